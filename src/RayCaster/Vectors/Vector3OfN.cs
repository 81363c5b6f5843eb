namespace RayCaster;

#pragma warning disable CS1591 // Vector3 explains the operators

/// <summary><see cref="Vector3"/> over any kind of number, with the operators that formulas of primitives need.</summary>
public readonly struct Vector3<N>(N x, N y, N z) where N : struct, IReal<N>
{
    public readonly N X = x, Y = y, Z = z;

    /// <summary>A constant vector, the same for every ray.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator Vector3<N>(Vector3 v) => new(v.X, v.Y, v.Z);

    public static Vector3<N> operator +(Vector3<N> a, Vector3<N> b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3<N> operator -(Vector3<N> a, Vector3<N> b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

    public static Vector3<N> operator -(Vector3<N> a) => new(-a.X, -a.Y, -a.Z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3<N> operator *(N b, Vector3<N> a) => new(b * a.X, b * a.Y, b * a.Z);

    public static Vector3<N> operator *(Vector3<N> a, N b) => b * a;

    public static Vector3<N> operator /(Vector3<N> a, N b) => N.Divide(a, b);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static N operator *(Vector3<N> a, Vector3<N> b) => a.X * b.X + a.Y * b.Y + a.Z * b.Z;

    public static Vector3<N> operator %(Vector3<N> a, Vector3<N> b) =>
        new(a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X);

    public override string ToString() => $"[{X}, {Y}, {Z}]";
}
