using System.Runtime.CompilerServices;

namespace RayCaster;

/// <summary>A box with its sides along the axes (slide "AABB (Axis Aligned Bounding Box)"); it may be flat.</summary>
/// <param name="Min">B0, the corner with the least coordinates.</param>
/// <param name="Max">B1, the corner with the greatest coordinates.</param>
public readonly record struct Aabb(Vector3 Min, Vector3 Max) : IPrimitive, IBounded, ISurface
{
    /// <inheritdoc/>
    public Bounds Bounds => new(Min, Max);

    /// <summary>The box is the intersection of three slabs. t_min is the last entry into a slab, t_max the first exit; the ray hits the box if
    /// t_min ≤ t_max.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Crossings<N> Intersect<N>(in Ray<N> ray) where N : struct, IReal<N>
    {
        var x = Slab<N>(Min.X, Max.X, ray.Origin.X, ray.Direction.X);
        var y = Slab<N>(Min.Y, Max.Y, ray.Origin.Y, ray.Direction.Y);
        var z = Slab<N>(Min.Z, Max.Z, ray.Origin.Z, ray.Direction.Z);
        var tMin = N.Max(N.Max(x.Near, y.Near), z.Near).As("t_min");
        var tMax = N.Min(N.Min(x.Far, y.Far), z.Far).As("t_max");
        var hit = tMin <= tMax;
        return new(N.If(hit, tMin), N.If(hit, tMax));
    }

    /// <summary>Where the ray enters and leaves the slab B0 ≤ coordinate ≤ B1, along one axis.</summary>
    /// <remarks>
    /// A ray parallel to the slab (d = 0) divides by 0. Inside this gives −∞ and +∞; outside twice the same infinity, so that the intersection
    /// is empty. Exactly on a face it gives 0 / 0, NaN: the face belongs to the slab, so the ray is inside from −∞ to +∞.
    /// </remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Crossings<N> Slab<N>(N B0, N B1, N P, N d) where N : struct, IReal<N>
    {
        var t0 = ((B0 - P) / d).As("t0");
        var t1 = ((B1 - P) / d).As("t1");
        return new(N.IfNaN(N.Min(t0, t1), double.NegativeInfinity), N.IfNaN(N.Max(t0, t1), double.PositiveInfinity));
    }

    /// <summary>The axis of the face that X lies on, outwards.</summary>
    Vector3 ISurface.Normal(Vector3 X) => FaceOf(X) switch
    {
        (0, var sign) => new(sign, 0, 0),
        (1, var sign) => new(0, sign, 0),
        var (_, sign) => new(0, 0, sign),
    };

    /// <summary>On each face the other two coordinates, in the order x, y, z, each from 0 at B0 to 1 at B1.</summary>
    (double U, double V) ISurface.Parameters(Vector3 X)
    {
        var (x, y, z) = (Part(X.X, Min.X, Max.X), Part(X.Y, Min.Y, Max.Y), Part(X.Z, Min.Z, Max.Z));
        return FaceOf(X).Axis switch { 0 => (y, z), 1 => (x, z), _ => (x, y) };

        static double Part(double x, double lo, double hi) => hi > lo ? (x - lo) / (hi - lo) : 0;
    }

    /// <summary>The face nearest to a point: its axis, and 1 for the side of B1, −1 for that of B0.</summary>
    private (int Axis, int Sign) FaceOf(Vector3 X)
    {
        ReadOnlySpan<double> toFaces =
            [Math.Abs(X.X - Min.X), Math.Abs(X.X - Max.X), Math.Abs(X.Y - Min.Y), Math.Abs(X.Y - Max.Y), Math.Abs(X.Z - Min.Z),
             Math.Abs(X.Z - Max.Z)];
        var nearest = 0;
        for (var i = 1; i < toFaces.Length; i++)
            if (toFaces[i] < toFaces[nearest])
                nearest = i;
        return (nearest / 2, nearest % 2 == 0 ? -1 : 1);
    }
}
