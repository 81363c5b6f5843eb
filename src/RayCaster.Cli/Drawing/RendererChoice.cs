using System.Runtime.CompilerServices;

namespace RayCaster.Cli;

/// <summary>
/// Chooses how to draw: small pictures by the definition, and others with the engine, until a pixel of the engine's differs from the definition.
/// In a native program the engine starts at once and draws small pictures, too. With <c>--plain</c>, draws every picture by the definition.
/// </summary>
/// <param name="manyFrames">Whether many pictures are drawn in this process (<see cref="Renderer.ManyFrames"/>).</param>
internal sealed class RendererChoice(Scene scene, int? threads, bool plain, bool manyFrames = false)
{
    /// <summary>The definition draws a picture of up to this many pixels in one call. It draws a larger one in strips, which need less
    /// memory.</summary>
    private const long PixelsAtOnce = 1 << 22;

    /// <summary>With no more rays times models, compiling the engine takes longer than drawing by the definition.</summary>
    private const long SmallWork = 3_000_000;

    private readonly Renderer engine = new(scene, threads) { ManyFrames = manyFrames };
    private readonly bool isByDefinition =
        plain || (!manyFrames && RuntimeFeature.IsDynamicCodeCompiled &&
            (double)scene.Camera.Width * scene.Camera.Height * Math.Max(1, scene.ShapeCount) <= SmallWork);

    public Scene Scene => scene;

    /// <param name="write">Receives whole lines of red, green and blue bytes.</param>
    /// <param name="linesDone">Called with the number of new finished lines, from any thread.</param>
    /// <param name="plain">Whether the definition draws, whatever else is chosen.</param>
    /// <returns>Where a pixel of the engine's differs from the definition, so that the lines are wrong; null if they are right.</returns>
    public string? Draw(NumberRange lines, Action<ReadOnlySpan<byte>> write, Action<int>? linesDone, bool plain)
    {
        if (!plain && !isByDefinition) return engine.Draw(lines.ToRange(), write, linesDone);
        DrawByDefinition(lines, write, linesDone);
        return null;
    }

    private void DrawByDefinition(NumberRange lines, Action<ReadOnlySpan<byte>> write, Action<int>? linesDone)
    {
        var atOnce = (int)Math.Clamp(PixelsAtOnce / scene.Camera.Width, 1, Math.Max(1, lines.Count / 50)); // and progress is shown
        for (var line = lines.First; line <= lines.Last; line += atOnce)
        {
            var window = new Picture(scene.Camera.Width, Math.Min(atOnce, lines.Last + 1 - line));
            ScalarRenderer.Render(scene, window, 0, line, threads ?? -1);
            linesDone?.Invoke(window.Height);
            write(window.Rgb);
        }
    }
}
