namespace RayCaster;

/// <summary>The definition of a picture, one ray after another. What draws faster must give the same bytes; in a build from source it is checked
/// against this.</summary>
public static class ScalarRenderer
{
    /// <summary>
    /// Whether this library was built from other sources than those with which the fast way was tested to agree (tested.sha256). Then pictures
    /// are compared with this
    /// definition while they are drawn.
    /// </summary>
    public static bool IsChanged =>
#if CHANGED
        true;
#else
        false;
#endif

    /// <summary>Draws the picture of a scene.</summary>
    public static Picture Render(Scene scene)
    {
        var picture = new Picture(scene.Camera.Width, scene.Camera.Height);
        Render(scene, picture);
        return picture;
    }

    /// <summary>Draws a window of the picture of a scene.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="window">Its pixels are set. It may be smaller than the picture.</param>
    /// <param name="left">The picture's column that is the window's first.</param>
    /// <param name="top">The picture's line, counted from the top, that is the window's first.</param>
    public static void Render(Scene scene, Picture window, int left = 0, int top = 0)
    {
        for (var y = 0; y < window.Height; y++)
        {
            var row = scene.Camera.Height - 1 - (top + y); // lines count from the top, rows from the bottom
            for (var x = 0; x < window.Width; x++)
            {
                var ray = Cast(scene, left + x, row);
                window[x, y] = scene.Shade(ray.HitParameter, ray.HitModel).ToBytes();
            }
        }
    }

    /// <summary>Casts the ray of a pixel through the scene; afterwards it knows its nearest hit.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="column">c, from the left.</param>
    /// <param name="row">r, from the bottom.</param>
    public static Ray Cast(Scene scene, int column, int row)
    {
        var ray = scene.Camera.CastRay(column, row);
        foreach (var model in scene.Models) ray.Meet(model);
        return ray;
    }
}
