using System.Runtime.CompilerServices;

namespace RayCaster;

/// <summary>Draws pictures the fast way: spans of pixels on several threads. Every byte is that of <see cref="ScalarRenderer"/>.</summary>
/// <param name="scene">What to draw.</param>
/// <param name="threads">How many threads cast rays; one per core if left out.</param>
public sealed class Renderer(Scene scene, int? threads = null)
{
    private const int PixelsAtOnce = 1 << 20;

    private readonly Camera camera = scene.Camera;
    private readonly Model[] models = [.. scene.Models];

    /// <summary>Draws a whole picture in memory, which must not have more than 2³¹ bytes.</summary>
    public static Picture Render(Scene scene, int? threads = null)
    {
        var picture = new Picture(scene.Camera.Width, scene.Camera.Height);
        new Renderer(scene, threads).DrawLines(0, picture.Height, picture.Rgb, null, default);
        return picture;
    }

    /// <summary>Draws the picture from top to bottom, a part at a time, so that memory does not grow with its height.</summary>
    /// <param name="write">Takes the lines of each part: red, green and blue bytes of whole lines.</param>
    /// <param name="lineDone">Called for each line when it is cast, from any thread.</param>
    /// <param name="cancellation">Stops the work with an <see cref="OperationCanceledException"/>.</param>
    public void Draw(Action<ReadOnlySpan<byte>> write, Action? lineDone = null, CancellationToken cancellation = default)
    {
        var linesAtOnce = Math.Clamp(PixelsAtOnce / camera.Width, 1, camera.Height);
        var rgb = new byte[linesAtOnce * camera.Width * 3];
        for (var line = 0; line < camera.Height; line += linesAtOnce)
        {
            var lines = Math.Min(linesAtOnce, camera.Height - line);
            DrawLines(line, lines, rgb, lineDone, cancellation);
            write(rgb.AsSpan(0, lines * camera.Width * 3));
        }
    }

    private void DrawLines(int firstLine, int lines, byte[] rgb, Action? lineDone, CancellationToken cancellation)
    {
        var options = new ParallelOptions { CancellationToken = cancellation, MaxDegreeOfParallelism = threads ?? Environment.ProcessorCount };
        Parallel.For(0, lines, options, () => new RaySpan(camera), (i, _, span) =>
        {
            DrawLine(span, camera.Height - 1 - (firstLine + i), rgb.AsSpan(i * camera.Width * 3, camera.Width * 3));
            lineDone?.Invoke();
            return span;
        }, _ => { });
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // a picture is often drawn before the runtime would optimise by itself
    private void DrawLine(RaySpan span, int row, Span<byte> rgb)
    {
        for (var column = 0; column < camera.Width; column += RaySpan.MaxLength)
        {
            var length = Math.Min(RaySpan.MaxLength, camera.Width - column);
            Cast(span, column, row, length);
            for (var i = 0; i < length; i++, rgb = rgb[3..])
            {
                var model = span.ModelAt(i);
                (rgb[0], rgb[1], rgb[2]) = scene.Shade(span.T[i], model < 0 ? null : models[model]).ToBytes();
            }
        }
    }

    /// <summary>Finds the nearest hits of up to <see cref="RaySpan.MaxLength"/> pixels.</summary>
    internal void Cast(RaySpan span, int column, int row, int length)
    {
        span.Aim(column, row, length);
        for (var i = 0; i < models.Length; i++) models[i].Meet(span, i);
    }
}
