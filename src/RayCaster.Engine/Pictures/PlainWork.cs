namespace RayCaster.Engine;

/// <summary>Says when a picture is so little work that saving work would cost more than it saves.</summary>
internal static class PlainWork
{
    /// <summary>From so many rays times models on it pays to find out which models show where. Tiles and intervals cost as much processor time
    /// before the first ray as 30 million crossings; most of it is compilation.</summary>
    private const long Large = 32_000_000;

    /// <summary>From so many pixels on another thread pays.</summary>
    private const long ManyPixels = 1 << 20;

    /// <summary>Whether each ray of these lines is simply intersected with each model near its pixel. A mesh is always prepared tile by
    /// tile.</summary>
    public static bool IsPlain(Scene scene, int lines)
    {
        if (RaysOf(scene, lines) * Math.Max(1, scene.Models.Count) >= Large) return false;
        for (var i = 0; i < scene.Models.Count; i++)
            if (scene.Models[i] is Mesh)
                return false;
        return true;
    }

    /// <summary>Whether one thread is enough for these lines.</summary>
    public static bool IsSmall(Scene scene, int lines) => RaysOf(scene, lines) < ManyPixels;

    private static long RaysOf(Scene scene, int lines) => (long)scene.Camera.Width * lines;
}
