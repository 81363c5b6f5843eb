namespace RayCaster.Engine;

/// <summary>Says when a picture is so little work that what spares work would cost more than it spares.</summary>
internal static class PlainWork
{
    /// <summary>How many rays times models make a picture so large that it pays to find out which models show where. A million take a millisecond;
    /// tiles and intervals cost 30 milliseconds of processor time before the first ray, most of it for the compiler.</summary>
    private const long Large = 32_000_000;

    /// <summary>How many pixels make it worth while to start another thread.</summary>
    private const long ManyPixels = 1 << 20;

    /// <summary>Whether every ray of these lines may as well meet every model that may show near its pixel. A mesh is always prepared tile by
    /// tile.</summary>
    public static bool IsPlain(Scene scene, int lines)
    {
        if (RaysOf(scene, lines) * Math.Max(1, scene.Models.Count) >= Large) return false;
        for (var i = 0; i < scene.Models.Count; i++)
            if (scene.Models[i] is Mesh)
                return false;
        return true;
    }

    /// <summary>Whether they are so few, too, that one thread does it all.</summary>
    public static bool IsSmall(Scene scene, int lines) => RaysOf(scene, lines) < ManyPixels;

    private static long RaysOf(Scene scene, int lines) => (long)scene.Camera.Width * lines;
}
