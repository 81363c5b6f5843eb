namespace RayCaster;

/// <summary>What a ray hits.</summary>
/// <param name="T">The ray parameter t; +∞ for no hit.</param>
/// <param name="Model">The model's place in <see cref="Scene.Models"/>, from 0; −1 for no hit.</param>
public readonly record struct Hit(double T, int Model)
{
    /// <summary>No hit.</summary>
    public static Hit None => new(double.PositiveInfinity, -1);
}
