namespace RayCaster.Cli;

/// <summary>
/// Draws with the engine. If the course's library was changed, compares some pixels with the definition, and draws by the definition as soon as
/// one differs. With <c>--plain</c>, draws by the definition from the start.
/// </summary>
/// <param name="manyFrames">Whether many pictures are drawn in this process (<see cref="Renderer.ManyFrames"/>).</param>
internal sealed class CheckedRenderer(Scene scene, int? threads, bool plain, bool manyFrames = false)
{
    /// <summary>The definition draws a picture of up to this many pixels in one call. It draws a larger one in strips, which need less
    /// memory.</summary>
    private const long PixelsAtOnce = 1 << 22;

    private readonly Renderer fast = new(scene, threads) { ManyFrames = manyFrames };
    private bool isByDefinition = plain;

    public Scene Scene => scene;

    /// <param name="write">Receives whole lines of red, green and blue bytes.</param>
    /// <param name="linesDone">Called with the number of new finished lines, from any thread.</param>
    /// <exception cref="FastWayDisagreesException">All lines were drawn, but some differ from the definition. A message was shown; the next call
    /// draws by the definition.</exception>
    public void Draw(LineRange lines, Action<ReadOnlySpan<byte>> write, Action<int>? linesDone, CancellationToken cancellation)
    {
        if (isByDefinition) DrawByDefinition(lines, write, linesDone, cancellation);
        else if (ScalarRenderer.IsChanged) DrawChecked(lines, write, linesDone, cancellation);
        else fast.Draw(lines, write, linesDone, cancellation);
    }

    /// <summary>Compares with the definition before any line is written.</summary>
    /// <exception cref="FastWayDisagreesException">Some lines differ.</exception>
    public void CheckInAdvance(LineRange lines, CancellationToken cancellation)
    {
        if (!isByDefinition && ScalarRenderer.IsChanged) DrawChecked(lines, _ => { }, null, cancellation);
    }

    private void DrawChecked(LineRange lines, Action<ReadOnlySpan<byte>> write, Action<int>? linesDone, CancellationToken cancellation)
    {
        var check = new DefinitionCheck(scene, lines);
        check.Watch(() => fast.Draw(lines, Take, linesDone, cancellation));
        if (check.FirstDifference() is not { } difference) return;
        StandardStreams.WriteError($"The fast way no longer agrees with your change: {difference}; drawn by ScalarRenderer.");
        isByDefinition = true;
        throw new FastWayDisagreesException();

        void Take(ReadOnlySpan<byte> drawn)
        {
            check.Take(drawn);
            write(drawn);
        }
    }

    private void DrawByDefinition(LineRange lines, Action<ReadOnlySpan<byte>> write, Action<int>? linesDone, CancellationToken cancellation)
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

/// <summary>The lines that were drawn are not the definition's and must not be kept.</summary>
internal sealed class FastWayDisagreesException : Exception;
