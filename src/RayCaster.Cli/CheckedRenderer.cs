namespace RayCaster.Cli;

/// <summary>
/// Draws the fast way; where the course's library was changed, as long as that agrees with the definition. Once it does not, or from the start
/// with <c>--plain</c>, the definition draws.
/// </summary>
/// <param name="scene">What to draw.</param>
/// <param name="threads">How many threads cast rays; null for one per core.</param>
/// <param name="plain">Whether the definition draws from the start.</param>
internal sealed class CheckedRenderer(Scene scene, int? threads, bool plain)
{
    /// <summary>The definition draws a picture of up to so many pixels in one call, as it is written; a larger one in strips, which need less
    /// memory.</summary>
    private const long PixelsAtOnce = 1 << 22;

    private bool isByDefinition = plain;

    /// <summary>What to draw.</summary>
    public Scene Scene => scene;

    /// <summary>Whether many pictures are drawn in this process (<see cref="Renderer.ManyFrames"/>).</summary>
    public bool ManyFrames { get; init; }

    /// <summary>Draws lines of the picture.</summary>
    /// <param name="lines">Which lines.</param>
    /// <param name="write">Takes whole lines in order.</param>
    /// <param name="linesDone">Told how many more lines have been cast, from any thread.</param>
    /// <param name="cancellation">Stops the work.</param>
    /// <exception cref="FastWayDisagreesException">All lines were taken, but some are not as the definition says. A message was shown; called
    /// again, this draws by the definition.</exception>
    public void Draw(LineRange lines, WriteLines write, Action<int>? linesDone, CancellationToken cancellation)
    {
        if (isByDefinition) DrawByDefinition(lines, write, linesDone, cancellation);
        else if (ScalarRenderer.IsChanged) DrawChecked(lines, write, linesDone, cancellation);
        else new Renderer(scene, threads) { ManyFrames = ManyFrames }.Draw(lines, write.Invoke, linesDone, cancellation);
    }

    /// <summary>Compares before anything is written.</summary>
    public void CheckInAdvance(LineRange lines, CancellationToken cancellation)
    {
        if (isByDefinition || !ScalarRenderer.IsChanged) return;
        try
        {
            DrawChecked(lines, _ => { }, null, cancellation);
        }
        catch (FastWayDisagreesException)
        {
            // The message is shown, and the definition draws from now on.
        }
    }

    private void DrawChecked(LineRange lines, WriteLines write, Action<int>? linesDone, CancellationToken cancellation)
    {
        var check = new DefinitionCheck(scene, lines);
        new Renderer(scene, threads) { ManyFrames = ManyFrames }.Draw(lines, Take, linesDone, cancellation);
        if (check.FirstDifference() is not { } difference) return;
        StandardFile.WriteError($"The fast way no longer agrees with your change: {difference}; drawn by ScalarRenderer.{Environment.NewLine}");
        isByDefinition = true;
        throw new FastWayDisagreesException();

        void Take(ReadOnlySpan<byte> drawn)
        {
            check.Take(drawn);
            write(drawn);
        }
    }

    private void DrawByDefinition(LineRange lines, WriteLines write, Action<int>? linesDone, CancellationToken cancellation)
    {
        var atOnce = (int)Math.Clamp(PixelsAtOnce / scene.Camera.Width, 1, lines.Count);
        for (var line = lines.First; line <= lines.Last; line += atOnce)
        {
            var (top, window) = (line, new Picture(scene.Camera.Width, Math.Min(atOnce, lines.Last + 1 - line)));
            cancellation.ThrowIfCancellationRequested();
            ScalarRenderer.Render(scene, window, 0, top);
            linesDone?.Invoke(window.Height);
            write(window.Rgb);
        }
    }
}

/// <summary>Takes whole lines of red, green and blue bytes.</summary>
internal delegate void WriteLines(ReadOnlySpan<byte> rgb);

/// <summary>What was drawn is not the definition's picture and must not be kept.</summary>
internal sealed class FastWayDisagreesException : Exception;
