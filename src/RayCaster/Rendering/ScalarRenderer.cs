namespace RayCaster;

/// <summary>The definition of a picture, one ray after another, for reading and for testing the fast way against it.</summary>
public static class ScalarRenderer
{
    /// <summary>Draws the picture of a scene.</summary>
    public static Picture Render(Scene scene)
    {
        var camera = scene.Camera;
        var picture = new Picture(camera.Width, camera.Height);
        for (var row = 0; row < camera.Height; row++)
            for (var column = 0; column < camera.Width; column++)
                picture[column, camera.Height - 1 - row] = Shade(scene, Cast(scene, column, row)).ToBytes();
        return picture;
    }

    /// <summary>Sends the ray of a pixel through the scene; it comes back with the nearest hit.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="column">c, from the left.</param>
    /// <param name="row">r, from the bottom.</param>
    public static Ray Cast(Scene scene, int column, int row)
    {
        var ray = scene.Camera.CastRay(column, row);
        foreach (var model in scene.Models) ray.Meet(model);
        return ray;
    }

    /// <summary>Slide "Attenuation": the farther the hit, the darker; black from twice the distance of the target on.</summary>
    public static Color Shade(Scene scene, Ray ray)
    {
        if (ray.HitModel is null) return scene.Background;
        var (Position, Target) = (scene.Camera.Position, scene.Camera.Target);
        var attenuation = Math.Max(0, 1 - ray.HitParameter / (2 * (Target - Position)).Length);
        return attenuation * ray.HitModel.Color;
    }
}
