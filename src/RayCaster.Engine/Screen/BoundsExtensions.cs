namespace RayCaster.Engine;

/// <summary>Which rays may hit what is in a box.</summary>
internal static class BoundsExtensions
{
    /// <summary>Bounds seen from a point, with a margin for what is rounded.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Bounds PaddedFrom(this Bounds bounds, Vector3 origin)
    {
        var (min, max) = Padded<Scalar>(bounds.Min, bounds.Max, origin);
        return new(new(min.X, min.Y, min.Z), new(max.X, max.Y, max.Z));
    }

    /// <summary>The corners of boxes seen from a point, with a margin for what is rounded.</summary>
    /// <remarks>
    /// A formula rounds by a few units of 2⁻⁵³ (1.1e-16). What it computes from differences to the ray's origin is then wrong by that part of the
    /// distance, and a hit at the silhouette of a far object may lie beside the box: 1e-12 of the distance holds thousands of such roundings. What
    /// it computes from coordinates, as X(t), is wrong by that part of the coordinates, which may be larger than the distance: 1e-14 of them holds
    /// dozens.
    /// </remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static (Vector3<N> Min, Vector3<N> Max) Padded<N>(Vector3<N> min, Vector3<N> max, Vector3<N> origin) where N : struct, IReal<N>
    {
        var ofCoordinates = 1e-14 * Largest(min, max);
        (min, max) = (min - origin, max - origin);
        var margin = 1e-12 * Largest(min, max) + ofCoordinates;
        return (min - new Vector3<N>(margin, margin, margin), max + new Vector3<N>(margin, margin, margin));
    }

    /// <summary>The largest absolute coordinate of a box.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static N Largest<N>(Vector3<N> min, Vector3<N> max) where N : struct, IReal<N> =>
        N.Max(N.Max(N.Max(-min.X, max.X), N.Max(-min.Y, max.Y)), N.Max(-min.Z, max.Z));

    /// <summary>No ray from the origin of space has a hit in a box at a lesser t; 0 where the box contains that origin.</summary>
    /// <remarks>
    /// It is a little less than the distance to the box. Along the axis k that a ray follows most, the triangle's formula computes a hit's
    /// coordinate z_k as a mean of the corners' coordinates, and t = z_k / d_k (<see cref="RaySpace{N}"/>). If a ray sees the triangle edge-on,
    /// rounding decides the mean's weights. Then z_k still lies in the box, so |z_k| ≥ near_k; the hit's two other coordinates need not. The ray
    /// itself meets the box, so |d_k| ≤ far_k / √(far_k² + near_i² + near_j²), where i and j are the two other axes. Both together give the least t
    /// along k, and the least of the three axes' is the result.
    /// </remarks>
    /// <param name="near">How far the box is from the origin along each axis.</param>
    /// <param name="far">How far it reaches, to either side.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static N LeastT<N>(Vector3<N> near, Vector3<N> far) where N : struct, IReal<N>
    {
        return N.Min(Along(near.X, far.X, near.Y, near.Z), N.Min(Along(near.Y, far.Y, near.Z, near.X), Along(near.Z, far.Z, near.X, near.Y)));

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static N Along(N near, N far, N nearI, N nearJ)
        {
            var (i, j) = (nearI / far, nearJ / far);
            var t = N.Select(near > 0, near * N.Sqrt(1 + i * i + j * j), 0);
            return N.Select((i > 1) | (j > 1), double.PositiveInfinity, t); // no ray to the box follows this axis most
        }
    }
}
