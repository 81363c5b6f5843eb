namespace Lab;

/// <summary>Something visible.</summary>
public abstract class Model
{
    public Color Color = new(1, 1, 1);

    /// <summary>Finds where the ray crosses this model and tells the ray each crossing by <see cref="Ray.Hit"/>.</summary>
    public abstract void Intersect(Ray ray);
}
