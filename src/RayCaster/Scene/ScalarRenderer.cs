namespace RayCaster;

/// <summary>The definition of a picture, one ray after another: slow, and right. The engine's pictures are spot-checked against it.</summary>
public static class ScalarRenderer
{
    /// <summary>Draws the picture of a scene.</summary>
    public static Picture Render(Scene scene)
    {
        var picture = new Picture(scene.Camera.Width, scene.Camera.Height);
        Render(scene, picture);
        return picture;
    }

    /// <summary>Draws a part of the picture of a scene, its lines on several threads.</summary>
    /// <param name="part">Receives the pixels. It may be smaller than the picture.</param>
    /// <param name="left">The picture's column at the part's left edge.</param>
    /// <param name="top">The picture's line, counted from the top, at the part's upper edge.</param>
    /// <param name="threads">The most threads; −1 for one per core.</param>
    public static void Render(Scene scene, Picture part, int left = 0, int top = 0, int threads = -1) =>
        Parallel.For(0, part.Height, new() { MaxDegreeOfParallelism = threads }, [MethodImpl(MethodImplOptions.AggressiveOptimization)] (y) =>
        {
            for (var x = 0; x < part.Width; x++) part[x, y] = Pixel(scene, left + x, top + y);
        });

    /// <summary>The bytes of a pixel.</summary>
    /// <param name="line">Counts from the top; rows count from the bottom.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public static (byte R, byte G, byte B) Pixel(Scene scene, int column, int line) =>
        scene.Shade(Cast(scene, column, scene.Camera.Height - 1 - line)).ToBytes();

    /// <summary>Casts the ray of a pixel through the scene, and returns its nearest hit; of equal ones the first.</summary>
    /// <param name="column">c, from the left.</param>
    /// <param name="row">r, from the bottom.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public static Hit Cast(Scene scene, int column, int row)
    {
        var ray = scene.Camera.RayThrough(column, row);
        var nearest = Hit.None;
        var models = scene.Models;
        for (var i = 0; i < models.Count; i++) // twice as fast as foreach over an interface
            if (models[i].Intersect(ray) is { } t && Ray.IsNearer<Scalar>(t, nearest.T).Holds) nearest = new(t, i);
        return nearest;
    }
}
