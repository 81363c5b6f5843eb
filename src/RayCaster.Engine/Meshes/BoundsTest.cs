namespace RayCaster.Engine;

/// <summary>Tests which rays miss bounds: slabs, as in <see cref="Aabb"/>, but a ray that is in doubt is not rejected.</summary>
internal readonly struct BoundsTest<N> where N : struct, IReal<N>
{
    private readonly N inverseX, inverseY, inverseZ;
    private readonly N mostlyX, isYAtLeastZ; // masks: the axis that a ray follows most, as RaySpace chooses it

    /// <param name="direction">The rays' directions; they share one origin.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public BoundsTest(Vector3<N> direction)
    {
        var (x, y, z) = (N.Max(direction.X, -direction.X), N.Max(direction.Y, -direction.Y), N.Max(direction.Z, -direction.Z));
        (mostlyX, isYAtLeastZ) = ((x >= y) & (x >= z), y >= z);
        (inverseX, inverseY, inverseZ) = ((N)1.0 / direction.X, (N)1.0 / direction.Y, (N)1.0 / direction.Z);
    }

    /// <summary>A mask of the rays that certainly cross nothing in the bounds from <paramref name="least"/> to <paramref name="most"/>.</summary>
    /// <param name="bounds">The bounds, seen from the rays' origin and padded.</param>
    /// <param name="least">Hits at a lesser t do not matter: 0 for those behind the origin.</param>
    /// <param name="most">Hits beyond this t do not matter.</param>
    /// <remarks>A ray within a face's plane multiplies 0 by ∞: NaN, which no comparison rejects. A triangle that is seen nearly edge-on may get a
    /// wrong t, but never one outside its corners' range along the ray's main axis; so only that axis tells what is too far or behind.</remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public N Misses(Bounds bounds, N least, N most)
    {
        var (x0, x1) = (bounds.Min.X * inverseX, bounds.Max.X * inverseX);
        var (y0, y1) = (bounds.Min.Y * inverseY, bounds.Max.Y * inverseY);
        var (z0, z1) = (bounds.Min.Z * inverseZ, bounds.Max.Z * inverseZ);
        var (nearX, farX) = (N.Min(x0, x1), N.Max(x0, x1));
        var (nearY, farY) = (N.Min(y0, y1), N.Max(y0, y1));
        var (nearZ, farZ) = (N.Min(z0, z1), N.Max(z0, z1));
        var missed = N.Max(nearX, N.Max(nearY, nearZ)) > N.Min(farX, N.Min(farY, farZ));
        var tooFar = N.Select(mostlyX, nearX, N.Select(isYAtLeastZ, nearY, nearZ)) > most;
        var tooNear = N.Select(mostlyX, farX, N.Select(isYAtLeastZ, farY, farZ)) < least;
        return missed | tooFar | tooNear;
    }
}
