namespace Lab;

/// <summary>Something visible.</summary>
public abstract class Model
{
    public Color Color = new(1, 1, 1);

    /// <summary>Finds the crossings of the ray with this model. Each t goes to <see cref="Ray.Hit"/>, which keeps the hit: the nearest
    /// that counts.</summary>
    public abstract void Intersect(Ray ray);
}
