namespace RayCaster;

/// <summary>Decides which crossings count: those beyond the bias, from the near to the far clip plane, both included.</summary>
public readonly struct ClipRange
{
    private readonly double least, zNear, zFar;

    /// <param name="bias">A crossing counts when t &gt; bias; with a bias of 0 when t ≥ 0.</param>
    public ClipRange(double bias, double zNear, double zFar)
    {
        least = bias == 0 ? 0 : Math.BitIncrement(bias); // t ≥ the next double is t > bias, and one comparison fits both cases
        (this.zNear, this.zFar) = (zNear, Math.Min(zFar, double.MaxValue)); // so that the infinite t of a parallel ray never counts
    }

    /// <summary>Everything that is not behind the ray's origin.</summary>
    public static ClipRange Everything { get; } = new(0, 0, double.PositiveInfinity);

    /// <summary>Whether a crossing counts; false where t is NaN.</summary>
    /// <param name="depthPerT"><see cref="Ray.DepthPerT"/>.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public N CountsMask<N>(N t, N depthPerT) where N : struct, IReal<N>
    {
        var z = t * depthPerT;
        return IsAhead(t) & IsBeyondNear(z) & IsWithinFar(z);
    }

    /// <summary>Beyond the bias (slide "Bias").</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public N IsAhead<N>(N t) where N : struct, IReal<N> => t >= least;

    /// <summary>Not nearer than the near clip plane (slide "zNear &amp; zFar").</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public N IsBeyondNear<N>(N z) where N : struct, IReal<N> => z >= zNear;

    /// <summary>Not beyond the far clip plane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public N IsWithinFar<N>(N z) where N : struct, IReal<N> => z <= zFar;

    /// <summary>The first of two crossings that counts, or NaN. Where the near side of a solid is clipped away, its far side shows.</summary>
    public N First<N>(Crossings<N> crossings, N depthPerT) where N : struct, IReal<N> =>
        First(crossings, depthPerT, CountsMask(crossings.Near, depthPerT));

    /// <summary>The same, for a caller that knows whether the near crossing counts.</summary>
    public N First<N>(Crossings<N> crossings, N depthPerT, N nearCounts) where N : struct, IReal<N> =>
        N.Select(nearCounts, crossings.Near, N.If(CountsMask(crossings.Far, depthPerT), crossings.Far));
}
