using RayCaster;

namespace Lab;

/// <summary>What the world holds, and the camera that looks at it.</summary>
public class Scene(Camera camera, Color background)
{
    public Camera Camera = camera;

    public Color Background = background; // of a pixel whose ray hits nothing; it is not attenuated

    public List<Model> Models = [];

    /// <summary>The colour of a pixel.</summary>
    public Color CastRay(int c, int r)
    {
        // BEGIN SOLUTION "Ray Casting"
        // STUB return Todo.Note("Ray Casting", new Color((double)c / Camera.Width, (double)r / Camera.Height, 0.5));
        var ray = Camera.RayThrough(c, r);
        foreach (var model in Models) model.Intersect(ray);
        return ray.HitModel == null ? Background : Camera.Shade(ray);
        // END SOLUTION
    }

    /// <summary>The loop over pixels. Rows count from the bottom, the picture's lines from the top.</summary>
    public Picture Draw()
    {
        var picture = new Picture(Camera.Width, Camera.Height);
        for (var r = 0; r < Camera.Height; r++)
            for (var c = 0; c < Camera.Width; c++) picture[c, Camera.Height - 1 - r] = CastRay(c, r).ToBytes();
        return picture;
    }
}
