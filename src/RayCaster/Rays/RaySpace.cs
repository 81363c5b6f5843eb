using System.Runtime.CompilerServices;

namespace RayCaster;

/// <summary>
/// The view along a ray. The axes are renamed so that z is the axis that d follows most; then points are sheared along d onto the plane z = 0.
/// There the ray is the point (0, 0), and a triangle around this point is one that the ray hits.
/// </summary>
public readonly struct RaySpace<N> where N : struct, IReal<N>
{
    private readonly Vector3<N> origin;
    private readonly N mostlyX, isYAtLeastZ; // masks: the axis that d follows most is x; otherwise y if it is at least z, else z
    private readonly N slopeX, slopeY;       // how far the ray moves sideways for one step along z

    /// <summary>d's coordinate along the renamed z: how far the ray moves along it for one unit of t.</summary>
    public readonly N Dz;

    /// <summary>Renames the axes for a ray; a zero in d needs no care, because the slopes divide by its largest coordinate.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public RaySpace(in Ray<N> ray)
    {
        var d = ray.Direction;
        var (x, y, z) = (N.Max(d.X, -d.X), N.Max(d.Y, -d.Y), N.Max(d.Z, -d.Z));
        origin = ray.Origin;
        mostlyX = (x >= y) & (x >= z);
        isYAtLeastZ = y >= z;
        d = PermuteAxes(d);
        (slopeX, slopeY, Dz) = (d.X / d.Z, d.Y / d.Z, d.Z);
    }

    /// <summary>A point in this view: X and Y across the ray, Z along it.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector3<N> Transform(Vector3<N> point)
    {
        var p = PermuteAxes(point - origin);
        return new(p.X - slopeX * p.Z, p.Y - slopeY * p.Z, p.Z);
    }

    /// <summary>Renames the axes in a cycle, which keeps their handedness.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private Vector3<N> PermuteAxes(Vector3<N> p) => new(
        N.Select(mostlyX, p.Y, N.Select(isYAtLeastZ, p.Z, p.X)),
        N.Select(mostlyX, p.Z, N.Select(isYAtLeastZ, p.X, p.Y)),
        N.Select(mostlyX, p.X, N.Select(isYAtLeastZ, p.Y, p.Z)));
}
