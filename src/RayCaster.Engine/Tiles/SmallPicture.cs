namespace RayCaster.Engine;

/// <summary>Draws some lines of a small picture on one thread.</summary>
/// <param name="scene">What to draw; no meshes, which are prepared tile by tile.</param>
internal sealed class SmallPicture(Scene scene)
{
    /// <summary>
    /// How many rays times models make a picture so large that it pays to find out which models show where. A million take a millisecond; tiles and intervals cost 30
    /// milliseconds of processor time before the first ray.
    /// </summary>
    private const long Large = 32_000_000;

    /// <summary>How many pixels make it worth a thread's while to cast some lines while others are written.</summary>
    private const long ManyPixels = 1 << 20;

    private readonly ModelView[] views = new ModelView[scene.Models.Count];
    private readonly SpanShader shader = new(scene, isLong: false);

    /// <summary>Whether these lines of a scene's picture are few enough to be cast the plain way.</summary>
    public static bool IsPlain(Scene scene, int lines)
    {
        var models = Math.Max(1, scene.Models.Count);
        if (RaysOf(scene, lines) * models >= Large) return false;
        for (var i = 0; i < scene.Models.Count; i++)
            if (scene.Models[i] is Mesh)
                return false;
        return true;
    }

    /// <summary>Whether they are so few, too, that one thread does it all.</summary>
    public static bool IsSmall(Scene scene, int lines) => RaysOf(scene, lines) < ManyPixels;

    /// <summary>Draws the lines; see <see cref="Renderer.Draw(Range, Action{ReadOnlySpan{byte}}, Action{int}?, CancellationToken)"/>.</summary>
    public void Draw(int first, int end, Action<ReadOnlySpan<byte>> write, Action<int>? linesDone, CancellationToken cancellation)
    {
        var camera = scene.Camera;
        for (var i = 0; i < views.Length; i++) views[i] = ViewMaker.See(scene.Models[i], camera, 1);
        var caster = new PlainCaster(camera, views);
        var rgb = new byte[3 * camera.Width * Math.Min(Tile.MaxSide, end - first)];
        while (first < end)
        {
            cancellation.ThrowIfCancellationRequested();
            var count = Math.Min(Tile.MaxSide, end - first);
            caster.Cast(new(0, camera.Height - first - count, camera.Width, count), new PictureSink(shader, rgb, camera.Width, camera.Height - 1 - first));
            linesDone?.Invoke(count);
            write(rgb.AsSpan(0, 3 * camera.Width * count));
            first += count;
        }
    }

    private static long RaysOf(Scene scene, int lines) => (long)scene.Camera.Width * lines;
}
