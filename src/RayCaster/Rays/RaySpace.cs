namespace RayCaster;

/// <summary>
/// Coordinates in which the ray is the z axis. First the axes are permuted so that z is the one along which d is longest; then a shear moves each
/// point sideways, by as much as the ray moves sideways up to the point's z. So the ray becomes (0, 0, z), and it hits a triangle whose X and Y
/// surround (0, 0).
/// </summary>
public readonly struct RaySpace<N> where N : struct, IReal<N>
{
    private readonly Vector3<N> origin;
    private readonly N mostlyX, isYAtLeastZ; // masks (true or false for each lane): d is longest along x; if not, along y rather than z
    private readonly N slopeX, slopeY;       // how far the ray moves sideways for one step along z

    /// <summary>d's coordinate along the permuted z: how far the ray moves along z for one unit of t.</summary>
    public readonly N Dz;

    /// <summary>Permutes the axes for a ray; a zero in d needs no care, because the slopes divide by its largest coordinate.</summary>
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

    /// <summary>Permutes the axes in a cycle, so that right-handed coordinates stay right-handed.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private Vector3<N> PermuteAxes(Vector3<N> p) => new(
        N.Select(mostlyX, p.Y, N.Select(isYAtLeastZ, p.Z, p.X)),
        N.Select(mostlyX, p.Z, N.Select(isYAtLeastZ, p.X, p.Y)),
        N.Select(mostlyX, p.X, N.Select(isYAtLeastZ, p.Y, p.Z)));
}
