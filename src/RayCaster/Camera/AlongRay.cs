using System.Runtime.CompilerServices;

namespace RayCaster;

/// <summary>The view along a ray: space pushed along d onto the coordinate plane that lies most across d, so that the ray is the point (0, 0).</summary>
/// <typeparam name="N">The kind of number.</typeparam>
internal readonly struct AlongRay<N> where N : struct, IReal<N>
{
    private readonly Vector3<N> origin;
    private readonly N alongX, alongY;       // masks: the axis that d follows most
    private readonly N slopeX, slopeY;       // how far d moves sideways for one step along that axis

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public AlongRay(in Ray<N> ray)
    {
        var d = ray.Direction;
        var (x, y, z) = (N.Max(d.X, -d.X), N.Max(d.Y, -d.Y), N.Max(d.Z, -d.Z));
        origin = ray.Origin;
        alongX = (x >= y) & (x >= z);
        alongY = y >= z;
        var turned = Turn(d);
        (slopeX, slopeY) = (turned.X / turned.Z, turned.Y / turned.Z);
    }

    /// <summary>Where a point is seen.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public (N X, N Y) See(Vector3<N> point)
    {
        var p = Turn(point - origin);
        return (p.X - slopeX * p.Z, p.Y - slopeY * p.Z);
    }

    /// <summary>Names the axes anew, in a cycle that keeps their handedness, so that d follows z most.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private Vector3<N> Turn(Vector3<N> p) => new(
        N.Select(alongX, p.Y, N.Select(alongY, p.Z, p.X)),
        N.Select(alongX, p.Z, N.Select(alongY, p.X, p.Y)),
        N.Select(alongX, p.X, N.Select(alongY, p.Y, p.Z)));
}
