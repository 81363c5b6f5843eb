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
        {
            for (var column = 0; column < camera.Width; column++)
            {
                var ray = Cast(scene, column, row);
                picture[column, camera.Height - 1 - row] = scene.Shade(ray.HitParameter, ray.HitModel).ToBytes();
            }
        }
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
}
