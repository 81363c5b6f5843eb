using System.Runtime.CompilerServices;

namespace RayCaster;

/// <summary>A box around something. It only rejects: a ray that misses it misses all that is in it.</summary>
/// <param name="Min">The least coordinates.</param>
/// <param name="Max">The greatest coordinates.</param>
public readonly record struct Bounds(Vector3 Min, Vector3 Max)
{
    /// <summary>Bounds of nothing.</summary>
    internal static Bounds Empty => new(
        new(double.PositiveInfinity, double.PositiveInfinity, double.PositiveInfinity),
        new(double.NegativeInfinity, double.NegativeInfinity, double.NegativeInfinity));

    /// <summary>Half of the surface; 0 for bounds of nothing.</summary>
    internal double HalfArea
    {
        get
        {
            var size = Max - Min;
            return size.X < 0 ? 0 : size.X * size.Y + size.Y * size.Z + size.Z * size.X;
        }
    }

    /// <summary>No ray from the origin of space has a hit in them at a lesser t; 0 where they hold that origin.</summary>
    internal double LeastT
    {
        get
        {
            var near = new Vector3(Math.Max(0, Math.Max(Min.X, -Max.X)), Math.Max(0, Math.Max(Min.Y, -Max.Y)), Math.Max(0, Math.Max(Min.Z, -Max.Z)));
            var far = new Vector3(Math.Max(-Min.X, Max.X), Math.Max(-Min.Y, Max.Y), Math.Max(-Min.Z, Max.Z));
            return LeastTOf<Scalar>(near, far);
        }
    }

    /// <summary>The same for any kind of number.</summary>
    /// <remarks>
    /// It is not quite the distance, which is right for hits that are in the box. A triangle's t is a mean of the corners' depths along the axis k
    /// that the ray follows most (<see cref="AlongRay{N}"/>), t = z / d_k; and where the triangle is seen so exactly edge-on that the weights are
    /// all noise, this may be
    /// the depth of any corner. So the ray meets the box, but of the hit only the coordinate along k is sure to lie in it. Of rays that meet the
    /// box,
    /// |d_k| ≤ far_k / √(far_k² + near_i² + near_j²), for the two other axes i and j.
    /// </remarks>
    /// <param name="near">How far the box is from the origin along each axis.</param>
    /// <param name="far">How far it reaches, to either side.</param>
    /// <typeparam name="N">The kind of number.</typeparam>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static N LeastTOf<N>(Vector3<N> near, Vector3<N> far) where N : struct, IReal<N>
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

    /// <summary>The bounds of these and a point.</summary>
    internal Bounds With(Vector3 p) => new(
        new(Math.Min(Min.X, p.X), Math.Min(Min.Y, p.Y), Math.Min(Min.Z, p.Z)),
        new(Math.Max(Max.X, p.X), Math.Max(Max.Y, p.Y), Math.Max(Max.Z, p.Z)));

    /// <summary>The bounds of both.</summary>
    internal Bounds With(Bounds other) => With(other.Min).With(other.Max);

    /// <summary>
    /// Seen from a point, these bounds grown by far more than a formula's rounding can move a hit sideways: a few units in the last place
    /// of the largest coordinate, against 1e-12 of it here. Without that margin hits at the silhouette of far things are lost.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal Bounds PaddedFrom(Vector3 origin)
    {
        var (min, max) = (Min - origin, Max - origin);
        var x = Math.Max(Math.Abs(min.X), Math.Abs(max.X));
        var y = Math.Max(Math.Abs(min.Y), Math.Abs(max.Y));
        var z = Math.Max(Math.Abs(min.Z), Math.Abs(max.Z));
        var margin = 1e-12 * Math.Max(x, Math.Max(y, z));
        return new(new(min.X - margin, min.Y - margin, min.Z - margin), new(max.X + margin, max.Y + margin, max.Z + margin));
    }
}

/// <summary>A shape within a ball, which is a tighter bound than a box for what is round.</summary>
internal interface IRound
{
    /// <summary>The middle of the ball.</summary>
    Vector3 Center { get; }

    /// <summary>No point of the shape is farther from there.</summary>
    double Radius { get; }
}

/// <summary>
/// A shape that says what it does not reach beyond. It need not: without bounds a shape is looked for everywhere, which takes
/// longer where there are thousands of them.
/// </summary>
public interface IBounded
{
    /// <summary>A box around the shape; it may be larger than needed, never smaller.</summary>
    Bounds Bounds { get; }
}
