using N = RayCaster.Engine.WidePacket;

namespace RayCaster.Engine;

/// <summary>All numbers from Lo to Hi, and NaN if that is marked. A formula over it gives the range of its results for all rays of a part of the
/// picture; each lane is another part. As a mask, Lo is where it certainly holds, Hi where it may hold.</summary>
/// <remarks>
/// It holds what doubles compute, not what real numbers would give, so nothing is rounded outwards: each operation is monotonic in each operand, and
/// so is rounding to nearest; so the result for operands between two ends lies between the results for the ends. Where a divisor may be 0, or an end
/// is infinite or NaN (0 · ∞, ∞ − ∞ and 0 / 0 may then lie between the ends), the answer is "anything". Of a quotient whose divisor may be 0,
/// <c>Gap</c> is then a lower bound of the absolute value: rays nearly parallel to a plane cross it far away, in front of the eye or behind it.
/// </remarks>
/// <param name="nan">Whether rays have NaN: <see cref="Never"/>, <see cref="Maybe"/>, or <see cref="Always"/>, where the ends mean nothing.</param>
/// <param name="gap">No number is nearer to 0 than this.</param>
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
internal readonly struct Interval(N lo, N hi, N nan, N gap) : IReal<Interval>
{
    private const double Never = 0, Maybe = 1, Always = 2;

    public readonly N Lo = lo, Hi = hi, NaN = nan, Gap = gap;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Interval(N lo, N hi) : this(lo, hi, Never, 0) { }

    /// <summary>A mask: no ray has a number.</summary>
    public N IsAlwaysNaN
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => NaN > Maybe;
    }

    /// <summary>A mask: some rays may have no number.</summary>
    public N MayBeNaN
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => NaN > Never;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator Interval(double value) =>
        double.IsNaN(value) ? new(double.PositiveInfinity, double.NegativeInfinity, Always, double.PositiveInfinity) : new(value, value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Interval operator +(Interval a, Interval b) => Sum(a, b, a.Lo + b.Lo, a.Hi + b.Hi);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Interval operator -(Interval a, Interval b) => Sum(a, b, a.Lo - b.Hi, a.Hi - b.Lo);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Interval operator -(Interval a) => new(-a.Hi, -a.Lo, a.NaN, a.Gap);

    public static Interval operator *(Interval a, Interval b) => Hull(a, b, a.Lo * b.Lo, a.Lo * b.Hi, a.Hi * b.Lo, a.Hi * b.Hi, 0);

    public static Interval operator /(Interval a, Interval b)
    {
        // A quotient by NaN is NaN, which Hull takes for anything.
        var mayBeZero = (b.Lo <= 0) & (b.Hi >= 0);
        var divisor = N.Select(mayBeZero, double.NaN, b.Lo);
        var gap = N.Greater(0, N.Greater(a.Lo, -a.Hi)) / N.Greater(-b.Lo, b.Hi);
        return Hull(a, b, a.Lo / divisor, a.Lo / b.Hi, a.Hi / divisor, a.Hi / b.Hi, N.Select(mayBeZero & (gap > 0), gap, 0)); // not if it is 0 / 0
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Interval operator <(Interval a, Interval b) => Mask(a, b, a.Hi < b.Lo, a.Lo < b.Hi);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Interval operator >(Interval a, Interval b) => Mask(a, b, a.Lo > b.Hi, a.Hi > b.Lo);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Interval operator <=(Interval a, Interval b) => Mask(a, b, a.Hi <= b.Lo, a.Lo <= b.Hi);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Interval operator >=(Interval a, Interval b) => Mask(a, b, a.Lo >= b.Hi, a.Hi >= b.Lo);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Interval operator &(Interval a, Interval b) => new(a.Lo & b.Lo, a.Hi & b.Hi);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Interval operator |(Interval a, Interval b) => new(a.Lo | b.Lo, a.Hi | b.Hi);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Interval Sqrt(Interval x)
    {
        var nan = N.Select(x.Hi < 0, Always, N.Select(x.Lo < 0, Maybe, Never));
        return new(N.Sqrt(N.Greater(0, x.Lo)), N.Sqrt(x.Hi), N.Greater(x.NaN, nan), 0);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Interval Min(Interval a, Interval b) =>
        new(N.Lesser(a.Lo, b.Lo), N.Lesser(a.Hi, b.Hi), N.Greater(a.NaN, b.NaN), N.Lesser(a.Gap, b.Gap));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Interval Max(Interval a, Interval b) =>
        new(N.Greater(a.Lo, b.Lo), N.Greater(a.Hi, b.Hi), N.Greater(a.NaN, b.NaN), N.Lesser(a.Gap, b.Gap));

    public static Interval Select(Interval mask, Interval a, Interval b)
    {
        // Either: the hull of what there is.
        N least = double.PositiveInfinity, most = double.NegativeInfinity;
        var (aIsAlwaysNaN, bIsAlwaysNaN) = (a.IsAlwaysNaN, b.IsAlwaysNaN);
        var lo = N.Lesser(N.Select(aIsAlwaysNaN, least, a.Lo), N.Select(bIsAlwaysNaN, least, b.Lo));
        var hi = N.Greater(N.Select(aIsAlwaysNaN, most, a.Hi), N.Select(bIsAlwaysNaN, most, b.Hi));
        var gap = N.Lesser(N.Select(aIsAlwaysNaN, least, a.Gap), N.Select(bIsAlwaysNaN, least, b.Gap));
        var nan = N.Select(aIsAlwaysNaN & bIsAlwaysNaN, Always, N.Lesser(N.Greater(a.NaN, b.NaN), Maybe));
        return new(Choose(a.Lo, lo, b.Lo), Choose(a.Hi, hi, b.Hi), Choose(a.NaN, nan, b.NaN), Choose(a.Gap, gap, b.Gap));

        N Choose(N surely, N either, N surelyNot) => N.Select(mask.Lo, surely, N.Select(mask.Hi, either, surelyNot));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Interval Mask(Interval a, Interval b, N surely, N maybe)
    {
        var nan = N.Greater(a.NaN, b.NaN);
        return new(N.Select(nan > Never, 0, surely), N.Select(nan > Maybe, 0, maybe));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Interval Sum(Interval a, Interval b, N lo, N hi) =>
        OrAnything(a, b, lo, hi, hi - lo < double.PositiveInfinity, 0); // false for NaN

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Interval Hull(Interval a, Interval b, N p, N q, N r, N s, N gap)
    {
        var sum = p + q + (r + s); // infinite or NaN if one of them is, which the least and the greatest need not tell
        var (lo, hi) = (N.Lesser(N.Lesser(p, q), N.Lesser(r, s)), N.Greater(N.Greater(p, q), N.Greater(r, s)));
        return OrAnything(a, b, lo, hi, sum - sum <= 0, gap);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Interval OrAnything(Interval a, Interval b, N lo, N hi, N isFinite, N gap)
    {
        var nan = N.Greater(a.NaN, b.NaN);
        return new(
            N.Select(isFinite, lo, double.NegativeInfinity), N.Select(isFinite, hi, double.PositiveInfinity),
            N.Select(isFinite, nan, N.Greater(nan, Maybe)), gap);
    }
}
