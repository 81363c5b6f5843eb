using System.Runtime.CompilerServices;

namespace RayCaster;

/// <summary>The definition of a picture, one ray after another. Some pixels of each picture that the engine draws are compared with it.</summary>
public static class ScalarRenderer
{
    /// <summary>Draws the picture of a scene.</summary>
    public static Picture Render(Scene scene)
    {
        var picture = new Picture(scene.Camera.Width, scene.Camera.Height);
        Render(scene, picture);
        return picture;
    }

    /// <summary>Draws a window of the picture of a scene.</summary>
    /// <param name="window">Receives the pixels. It may be smaller than the picture.</param>
    /// <param name="left">The picture's column at the window's left edge.</param>
    /// <param name="top">The picture's line, counted from the top, at the window's upper edge.</param>
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

    /// <summary>Casts the ray of a pixel through the scene; the result holds its nearest hit.</summary>
    /// <param name="column">c, from the left.</param>
    /// <param name="row">r, from the bottom.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public static Ray Cast(Scene scene, int column, int row)
    {
        var ray = scene.Camera.RayThrough(column, row);
        foreach (var model in scene.Models) ray.Intersect(model);
        return ray;
    }
}
