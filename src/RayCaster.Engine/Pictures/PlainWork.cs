namespace RayCaster.Engine;

/// <summary>Decides when a picture is so little work that saving work would cost more than it saves.</summary>
internal static class PlainWork
{
    /// <summary>With more rays times models, finding out which models show where saves time. Before the first ray, tiles and intervals cost as much
    /// processor time as 30 million crossings; most of it is compilation.</summary>
    private const long Large = 32_000_000;

    /// <summary>With more pixels, a second thread saves time.</summary>
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
