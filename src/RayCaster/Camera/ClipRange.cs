using System.Runtime.CompilerServices;

namespace RayCaster;

/// <summary>Which crossings count: those beyond the bias and between the near and the far clip plane, both included.</summary>
public readonly struct ClipRange
{
    private readonly double least, zNear, zFar;

    /// <param name="bias">A crossing counts when t &gt; bias; with a bias of 0 when t ≥ 0.</param>
    /// <param name="zNear">The least z that counts.</param>
    /// <param name="zFar">The greatest z that counts.</param>
    public ClipRange(double bias, double zNear, double zFar)
    {
        least = bias == 0 ? 0 : Math.BitIncrement(bias); // t ≥ the next double says the same as t > bias
        (this.zNear, this.zFar) = (zNear, Math.Min(zFar, double.MaxValue)); // a parallel ray's infinite t counts in no case
    }

    /// <summary>Everything that is not behind the ray's origin.</summary>
    public static ClipRange Everything => new(0, 0, double.PositiveInfinity);

    /// <summary>Where a crossing counts; nowhere where t is NaN.</summary>
    /// <param name="t">The ray parameter of the crossing.</param>
    /// <param name="zPerT">What z gains for one unit of t.</param>
    /// <typeparam name="N">The kind of number.</typeparam>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public N Counts<N>(N t, N zPerT) where N : struct, IReal<N>
    {
        var z = t * zPerT;
        return (t >= least) & (z >= zNear) & (z <= zFar);
    }

    /// <summary>The part of <see cref="Counts"/> that asks whether a crossing is beyond the bias.</summary>
    internal bool IsAhead(double t) => t >= least;

    /// <summary>The part that asks whether it is not nearer than zNear.</summary>
    internal bool IsBeyondNear(double z) => z >= zNear;

    /// <summary>The part that asks whether it is not beyond zFar.</summary>
    internal bool IsWithinFar(double z) => z <= zFar;

    /// <summary>The first of two crossings that counts, or NaN: the far side of a body shows where its near side is clipped away.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public N First<N>(Crossings<N> crossings, N zPerT) where N : struct, IReal<N> =>
        First(crossings, zPerT, Counts(crossings.Near, zPerT));

    /// <summary>The same for a caller that knows where the first of the two counts.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal N First<N>(Crossings<N> crossings, N zPerT, N nearCounts) where N : struct, IReal<N> =>
        N.Select(nearCounts, crossings.Near, N.If(Counts(crossings.Far, zPerT), crossings.Far));
}
