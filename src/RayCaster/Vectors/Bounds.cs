namespace RayCaster;

/// <summary>A box around something. It only rejects: a ray that misses the box misses everything in it.</summary>
public readonly record struct Bounds(Vector3 Min, Vector3 Max)
{
    /// <summary>The bounds of nothing: add points to them.</summary>
    public static Bounds Empty => new(
        new(double.PositiveInfinity, double.PositiveInfinity, double.PositiveInfinity),
        new(double.NegativeInfinity, double.NegativeInfinity, double.NegativeInfinity));

    /// <summary>The bounds of these and a point.</summary>
    public Bounds With(Vector3 p) => new(
        new(Math.Min(Min.X, p.X), Math.Min(Min.Y, p.Y), Math.Min(Min.Z, p.Z)),
        new(Math.Max(Max.X, p.X), Math.Max(Max.Y, p.Y), Math.Max(Max.Z, p.Z)));

    /// <summary>The bounds of both.</summary>
    public Bounds With(Bounds other) => With(other.Min).With(other.Max);
}
