namespace RayCaster;

/// <summary>A point or a direction in space (slide "IDE &amp; Vectors").</summary>
/// <param name="Z">The coordinate along the z axis, which is up in most scenes.</param>
public readonly record struct Vector3(double X, double Y, double Z)
{
    /// <summary>The origin (0, 0, 0).</summary>
    public static Vector3 Zero => default;

    /// <summary>√(x² + y² + z²), exact to the last bits even where the squares leave the range of a double.</summary>
    public double Length
    {
        get
        {
            var square = this * this;
            if (square is > 1e-280 and < 1e280) return Math.Sqrt(square);
            // Such squares have lost digits or overflowed: compute in units of the largest coordinate.
            var largest = Math.Max(Math.Abs(X), Math.Max(Math.Abs(Y), Math.Abs(Z)));
            if (largest == 0 || !double.IsFinite(largest)) return largest;
            var scaled = new Vector3(X / largest, Y / largest, Z / largest);
            return largest * Math.Sqrt(scaled * scaled);
        }
    }

    /// <summary>The vector of length 1 in the same direction; NaN for the zero vector, which has no direction.</summary>
    public Vector3 Normalized => this / Length;

    /// <summary>Adds coordinate by coordinate.</summary>
    public static Vector3 operator +(Vector3 a, Vector3 b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

    /// <summary>The vector from point b to point a.</summary>
    public static Vector3 operator -(Vector3 a, Vector3 b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

    /// <summary>The opposite direction.</summary>
    public static Vector3 operator -(Vector3 a) => new(-a.X, -a.Y, -a.Z);

    /// <summary>Multiplies each coordinate by a number.</summary>
    public static Vector3 operator *(double b, Vector3 a) => new(b * a.X, b * a.Y, b * a.Z);

    /// <inheritdoc cref="op_Multiply(double, Vector3)"/>
    public static Vector3 operator *(Vector3 a, double b) => b * a;

    /// <summary>Divides each coordinate. This rounds once; multiplying by 1 / b would round twice.</summary>
    public static Vector3 operator /(Vector3 a, double b) => new(a.X / b, a.Y / b, a.Z / b);

    /// <summary>Dot product: |a| |b| cos φ, φ being the angle between a and b (slide "IDE &amp; Vectors").</summary>
    public static double operator *(Vector3 a, Vector3 b) => a.X * b.X + a.Y * b.Y + a.Z * b.Z;

    /// <summary>Cross product: perpendicular to a and b, right-handed, of length |a| |b| sin φ (slide "IDE &amp; Vectors").</summary>
    public static Vector3 operator %(Vector3 a, Vector3 b) =>
        new(a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X);

    /// <summary>Writes <c>[1, 2.5, -3]</c>, as in a scene file, with all digits needed to read the same numbers back.</summary>
    public override string ToString() => FormattableString.Invariant($"[{X:R}, {Y:R}, {Z:R}]");
}
