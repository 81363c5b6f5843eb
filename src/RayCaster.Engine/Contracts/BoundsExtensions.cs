namespace RayCaster.Engine;

/// <summary>Which rays may hit what is in a box.</summary>
public static class BoundsExtensions
{
    /// <summary>Bounds seen from a point, with a margin of 1e-12 of their largest coordinate. The rounding of a formula moves a hit sideways by far
    /// less, a few units in the last place; without a margin, hits at the silhouettes of far objects are lost.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Bounds PaddedFrom(this Bounds bounds, Vector3 origin)
    {
        var (min, max) = (bounds.Min - origin, bounds.Max - origin);
        var x = Math.Max(Math.Abs(min.X), Math.Abs(max.X));
        var y = Math.Max(Math.Abs(min.Y), Math.Abs(max.Y));
        var z = Math.Max(Math.Abs(min.Z), Math.Abs(max.Z));
        var margin = 1e-12 * Math.Max(x, Math.Max(y, z));
        return new(new(min.X - margin, min.Y - margin, min.Z - margin), new(max.X + margin, max.Y + margin, max.Z + margin));
    }

    /// <summary>No ray from the origin of space has a hit in a box at a lesser t; 0 where the box contains that origin.</summary>
    /// <remarks>
    /// It is a little less than the distance. A triangle's t is a mean of its corners' depths along the axis k that the ray follows most
    /// (<see cref="RaySpace{N}"/>), t = z / d_k. For a triangle that is seen almost exactly edge-on the weights of that mean are all rounding,
    /// and t may be the depth of any corner: the ray meets the box, but only the hit's coordinate along k is sure to lie in it. Of rays that
    /// meet the box, |d_k| ≤ far_k / √(far_k² + near_i² + near_j²), where i and j are the two other axes.
    /// </remarks>
    /// <param name="near">How far the box is from the origin along each axis.</param>
    /// <param name="far">How far it reaches, to either side.</param>
    /// <typeparam name="N">The kind of number.</typeparam>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static N LeastT<N>(Vector3<N> near, Vector3<N> far) where N : struct, IReal<N>
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
