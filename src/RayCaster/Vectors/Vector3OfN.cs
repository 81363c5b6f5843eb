namespace RayCaster;

/// <summary><see cref="Vector3"/> over any kind of number, with the operators that formulas of primitives need.</summary>
public readonly struct Vector3<N>(N x, N y, N z) where N : struct, IReal<N>
{
    /// <summary>The x coordinate.</summary>
    public readonly N X = x;

    /// <summary>The y coordinate.</summary>
    public readonly N Y = y;

    /// <summary>The z coordinate.</summary>
    public readonly N Z = z;

    /// <summary>A constant vector, the same for every ray.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator Vector3<N>(Vector3 v) => new(v.X, v.Y, v.Z);

    /// <summary>Sum.</summary>
    public static Vector3<N> operator +(Vector3<N> a, Vector3<N> b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

    /// <summary>The vector from point b to point a.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3<N> operator -(Vector3<N> a, Vector3<N> b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

    /// <summary>The opposite direction.</summary>
    public static Vector3<N> operator -(Vector3<N> a) => new(-a.X, -a.Y, -a.Z);

    /// <summary>Multiplies each coordinate by a number.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3<N> operator *(N b, Vector3<N> a) => new(b * a.X, b * a.Y, b * a.Z);

    /// <inheritdoc cref="op_Multiply(N, Vector3{N})"/>
    public static Vector3<N> operator *(Vector3<N> a, N b) => b * a;

    /// <summary>Divides each coordinate.</summary>
    public static Vector3<N> operator /(Vector3<N> a, N b) => N.Divide(a, b);

    /// <summary>Dot product.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static N operator *(Vector3<N> a, Vector3<N> b) => a.X * b.X + a.Y * b.Y + a.Z * b.Z;

    /// <summary>Cross product.</summary>
    public static Vector3<N> operator %(Vector3<N> a, Vector3<N> b) =>
        new(a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X);

    /// <summary>The coordinates, as in a scene file.</summary>
    public override string ToString() => $"[{X}, {Y}, {Z}]";
}
