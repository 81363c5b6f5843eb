namespace Lab;

/// <summary>Something visible.</summary>
public abstract class Model
{
    public Color Color = new(1, 1, 1);

    /// <summary>Finds the intersections of the ray with this model and gives t of each to <see cref="Ray.Hit"/>.</summary>
    public abstract void Intersect(Ray ray);
}
