using System.Runtime.Intrinsics;

namespace RayCaster;

/// <summary>
/// Draws some lines of a small picture on one thread: every ray meets every model. What a <see cref="BandQueue"/> does to spare work would take longer to
/// compile than all of that work takes.
/// </summary>
/// <param name="scene">What to draw; no meshes, which are prepared tile by tile.</param>
internal sealed class SmallPicture(Scene scene)
{
    /// <summary>
    /// How many rays times models make a picture large. A million take a millisecond; the start of threads, tiles and intervals costs 40 milliseconds of
    /// processor time.
    /// </summary>
    private const long Large = 32_000_000;

    private readonly ModelView[] views = new ModelView[scene.Models.Count];
    private readonly RaySpan span = new(scene.Camera);
    private readonly SpanShader shader = new(scene, isLong: false);

    /// <summary>Whether these lines of a scene's picture are few enough.</summary>
    public static bool IsSmall(Scene scene, LineRange lines)
    {
        var models = Math.Max(1, scene.Models.Count);
        if ((long)scene.Camera.Width * lines.Count * models >= Large) return false;
        for (var i = 0; i < scene.Models.Count; i++)
            if (scene.Models[i] is Mesh)
                return false;
        return true;
    }

    /// <summary>Draws the lines; see <see cref="Renderer.Draw(LineRange, Action{ReadOnlySpan{byte}}, Action{int}?, CancellationToken)"/>.</summary>
    public void Draw(LineRange lines, Action<ReadOnlySpan<byte>> write, Action<int>? linesDone, CancellationToken cancellation)
    {
        var (camera, first) = (scene.Camera, lines.First);
        for (var i = 0; i < views.Length; i++) views[i] = scene.Models[i].See(camera, 1);
        var rgb = new byte[3 * camera.Width * Math.Min(Tile.MaxSide, lines.Count)];
        while (first <= lines.Last)
        {
            cancellation.ThrowIfCancellationRequested();
            var count = Math.Min(Tile.MaxSide, lines.Last + 1 - first);
            var sink = new PictureSink(shader, rgb, camera.Width, camera.Height - 1 - first);
            for (var column = 0; column < camera.Width; column += RaySpan.MaxLength)
            {
                var part = new Tile(column, camera.Height - first - count, Math.Min(RaySpan.MaxLength, camera.Width - column), count);
                if (Vector512.IsHardwareAccelerated) Cast<WidePacket>(part, sink);
                else Cast<Packet>(part, sink);
            }
            linesDone?.Invoke(count);
            write(rgb.AsSpan(0, 3 * camera.Width * count));
            first += count;
        }
    }

    private void Cast<N>(in Tile part, PictureSink sink) where N : struct, IPacket<N>
    {
        span.Enter<N>(part.Column, part.Width);
        for (var row = part.Row; row < part.EndRow; row++)
        {
            span.Aim<N>(row);
            for (var i = 0; i < views.Length; i++) views[i].Meet(span, i);
            sink.Take(span);
        }
    }
}
