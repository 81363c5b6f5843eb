using Numbers = RayCaster.Engine.WidePacket;

namespace RayCaster.Engine;

/// <summary>The numbers from Lo to Hi, and NaN if that is marked: what a formula gives for the rays of a part of the picture. Each lane is another
/// part. Of a mask, Lo says where it holds for all rays, and Hi where it may hold for some.</summary>
/// <remarks>
/// An interval holds what doubles compute. Each operation, and rounding, keeps the order of numbers: so a result lies between the results for the
/// ends, and the ends need not be rounded outwards. If a divisor may be 0, or an end is infinite or NaN, the result is "anything", since 0 · ∞,
/// ∞ − ∞ or 0 / 0 may occur between the ends. A quotient whose divisor may be 0 is large on both sides: rays that are nearly parallel to a plane
/// cross it far in front of the eye, or far behind it. <c>Gap</c> says how far from 0 it is at least.
/// </remarks>
/// <param name="nan">The <see cref="Occurrence"/> of NaN; where it is always, the ends mean nothing.</param>
/// <param name="gap">The least absolute value of a number in it, which interval arithmetic calls mignitude; or less, down to 0.</param>
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
internal readonly struct Interval(Numbers lo, Numbers hi, Numbers nan, Numbers gap) : IReal<Interval>
{
    /// <summary>Whether rays have NaN; a lane holds its number.</summary>
    private enum Occurrence
    {
        Never,
        Maybe,
        Always,
    }

    public readonly Numbers Lo = lo, Hi = hi, NaN = nan, Gap = gap;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Interval(Numbers lo, Numbers hi) : this(lo, hi, In(Occurrence.Never), 0) { }

    /// <summary>A mask: no ray has a number.</summary>
    public Numbers IsAlwaysNaN
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => NaN > In(Occurrence.Maybe);
    }

    /// <summary>A mask: some rays may have no number.</summary>
    public Numbers MayBeNaN
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => NaN > In(Occurrence.Never);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator Interval(double value) =>
        double.IsNaN(value)
            ? new(double.PositiveInfinity, double.NegativeInfinity, In(Occurrence.Always), double.PositiveInfinity)
            : new(value, value);

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
        var divisor = Numbers.Select(mayBeZero, double.NaN, b.Lo);
        var gap = Numbers.Greater(0, Numbers.Greater(a.Lo, -a.Hi)) / Numbers.Greater(-b.Lo, b.Hi);
        var isGap = mayBeZero & (gap > 0); // not if it is 0 / 0
        return Hull(a, b, a.Lo / divisor, a.Lo / b.Hi, a.Hi / divisor, a.Hi / b.Hi, Numbers.Select(isGap, gap, 0));
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
        var nan = Numbers.Select(x.Hi < 0, In(Occurrence.Always), Numbers.Select(x.Lo < 0, In(Occurrence.Maybe), In(Occurrence.Never)));
        return new(Numbers.Sqrt(Numbers.Greater(0, x.Lo)), Numbers.Sqrt(x.Hi), Numbers.Greater(x.NaN, nan), 0);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Interval Min(Interval a, Interval b) =>
        new(Numbers.Lesser(a.Lo, b.Lo), Numbers.Lesser(a.Hi, b.Hi), Numbers.Greater(a.NaN, b.NaN), Numbers.Lesser(a.Gap, b.Gap));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Interval Max(Interval a, Interval b) =>
        new(Numbers.Greater(a.Lo, b.Lo), Numbers.Greater(a.Hi, b.Hi), Numbers.Greater(a.NaN, b.NaN), Numbers.Lesser(a.Gap, b.Gap));

    public static Interval Select(Interval mask, Interval a, Interval b)
    {
        // Either: the hull of what there is.
        Numbers least = double.PositiveInfinity, most = double.NegativeInfinity;
        var (aIsAlwaysNaN, bIsAlwaysNaN) = (a.IsAlwaysNaN, b.IsAlwaysNaN);
        var lo = Numbers.Lesser(Numbers.Select(aIsAlwaysNaN, least, a.Lo), Numbers.Select(bIsAlwaysNaN, least, b.Lo));
        var hi = Numbers.Greater(Numbers.Select(aIsAlwaysNaN, most, a.Hi), Numbers.Select(bIsAlwaysNaN, most, b.Hi));
        var gap = Numbers.Lesser(Numbers.Select(aIsAlwaysNaN, least, a.Gap), Numbers.Select(bIsAlwaysNaN, least, b.Gap));
        var someNaN = Numbers.Lesser(Numbers.Greater(a.NaN, b.NaN), In(Occurrence.Maybe));
        var nan = Numbers.Select(aIsAlwaysNaN & bIsAlwaysNaN, In(Occurrence.Always), someNaN);
        return new(Choose(a.Lo, lo, b.Lo), Choose(a.Hi, hi, b.Hi), Choose(a.NaN, nan, b.NaN), Choose(a.Gap, gap, b.Gap));

        Numbers Choose(Numbers surely, Numbers either, Numbers surelyNot) =>
            Numbers.Select(mask.Lo, surely, Numbers.Select(mask.Hi, either, surelyNot));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Numbers In(Occurrence occurrence) => (double)occurrence;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Interval Mask(Interval a, Interval b, Numbers surely, Numbers maybe)
    {
        var nan = Numbers.Greater(a.NaN, b.NaN);
        return new(Numbers.Select(nan > In(Occurrence.Never), 0, surely), Numbers.Select(nan > In(Occurrence.Maybe), 0, maybe));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Interval Sum(Interval a, Interval b, Numbers lo, Numbers hi) =>
        OrAnything(a, b, lo, hi, hi - lo < double.PositiveInfinity, 0); // false for NaN

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Interval Hull(Interval a, Interval b, Numbers p, Numbers q, Numbers r, Numbers s, Numbers gap)
    {
        var sum = p + q + (r + s); // infinite or NaN if one of them is, which the least and the greatest need not tell
        var lo = Numbers.Lesser(Numbers.Lesser(p, q), Numbers.Lesser(r, s));
        var hi = Numbers.Greater(Numbers.Greater(p, q), Numbers.Greater(r, s));
        return OrAnything(a, b, lo, hi, sum - sum <= 0, gap);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Interval OrAnything(Interval a, Interval b, Numbers lo, Numbers hi, Numbers isFinite, Numbers gap)
    {
        var nan = Numbers.Greater(a.NaN, b.NaN);
        return new(
            Numbers.Select(isFinite, lo, double.NegativeInfinity), Numbers.Select(isFinite, hi, double.PositiveInfinity),
            Numbers.Select(isFinite, nan, Numbers.Greater(nan, In(Occurrence.Maybe))), gap);
    }
}
