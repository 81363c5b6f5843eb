using Lanes8 = RayCaster.Engine.WidePacket;

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
internal readonly struct Interval(Lanes8 lo, Lanes8 hi, Lanes8 nan, Lanes8 gap) : IReal<Interval>
{
    /// <summary>Whether rays have NaN; a lane holds its number.</summary>
    private enum Occurrence
    {
        Never,
        Maybe,
        Always,
    }

    public readonly Lanes8 Lo = lo, Hi = hi, NaN = nan, Gap = gap;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Interval(Lanes8 lo, Lanes8 hi) : this(lo, hi, In(Occurrence.Never), 0) { }

    /// <summary>A mask: no ray has a number.</summary>
    public Lanes8 IsAlwaysNaN
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => NaN > In(Occurrence.Maybe);
    }

    /// <summary>A mask: some rays may have no number.</summary>
    public Lanes8 MayBeNaN
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
        var divisor = Lanes8.Select(mayBeZero, double.NaN, b.Lo);
        var gap = Lanes8.MaxNative(0, Lanes8.MaxNative(a.Lo, -a.Hi)) / Lanes8.MaxNative(-b.Lo, b.Hi);
        var isGap = mayBeZero & (gap > 0); // not if it is 0 / 0
        return Hull(a, b, a.Lo / divisor, a.Lo / b.Hi, a.Hi / divisor, a.Hi / b.Hi, Lanes8.Select(isGap, gap, 0));
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
        var nan = Lanes8.Select(x.Hi < 0, In(Occurrence.Always), Lanes8.Select(x.Lo < 0, In(Occurrence.Maybe), In(Occurrence.Never)));
        return new(Lanes8.Sqrt(Lanes8.MaxNative(0, x.Lo)), Lanes8.Sqrt(x.Hi), Lanes8.MaxNative(x.NaN, nan), 0);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Interval Min(Interval a, Interval b) =>
        new(Lanes8.MinNative(a.Lo, b.Lo), Lanes8.MinNative(a.Hi, b.Hi), Lanes8.MaxNative(a.NaN, b.NaN), Lanes8.MinNative(a.Gap, b.Gap));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Interval Max(Interval a, Interval b) =>
        new(Lanes8.MaxNative(a.Lo, b.Lo), Lanes8.MaxNative(a.Hi, b.Hi), Lanes8.MaxNative(a.NaN, b.NaN), Lanes8.MinNative(a.Gap, b.Gap));

    public static Interval Select(Interval mask, Interval a, Interval b)
    {
        // Either: the hull of what there is.
        Lanes8 least = double.PositiveInfinity, most = double.NegativeInfinity;
        var (aIsAlwaysNaN, bIsAlwaysNaN) = (a.IsAlwaysNaN, b.IsAlwaysNaN);
        var lo = Lanes8.MinNative(Lanes8.Select(aIsAlwaysNaN, least, a.Lo), Lanes8.Select(bIsAlwaysNaN, least, b.Lo));
        var hi = Lanes8.MaxNative(Lanes8.Select(aIsAlwaysNaN, most, a.Hi), Lanes8.Select(bIsAlwaysNaN, most, b.Hi));
        var gap = Lanes8.MinNative(Lanes8.Select(aIsAlwaysNaN, least, a.Gap), Lanes8.Select(bIsAlwaysNaN, least, b.Gap));
        var someNaN = Lanes8.MinNative(Lanes8.MaxNative(a.NaN, b.NaN), In(Occurrence.Maybe));
        var nan = Lanes8.Select(aIsAlwaysNaN & bIsAlwaysNaN, In(Occurrence.Always), someNaN);
        return new(Choose(a.Lo, lo, b.Lo), Choose(a.Hi, hi, b.Hi), Choose(a.NaN, nan, b.NaN), Choose(a.Gap, gap, b.Gap));

        Lanes8 Choose(Lanes8 surely, Lanes8 either, Lanes8 surelyNot) =>
            Lanes8.Select(mask.Lo, surely, Lanes8.Select(mask.Hi, either, surelyNot));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Lanes8 In(Occurrence occurrence) => (double)occurrence;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Interval Mask(Interval a, Interval b, Lanes8 surely, Lanes8 maybe)
    {
        var nan = Lanes8.MaxNative(a.NaN, b.NaN);
        return new(Lanes8.Select(nan > In(Occurrence.Never), 0, surely), Lanes8.Select(nan > In(Occurrence.Maybe), 0, maybe));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Interval Sum(Interval a, Interval b, Lanes8 lo, Lanes8 hi) =>
        OrAnything(a, b, lo, hi, hi - lo < double.PositiveInfinity, 0); // false for NaN

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Interval Hull(Interval a, Interval b, Lanes8 p, Lanes8 q, Lanes8 r, Lanes8 s, Lanes8 gap)
    {
        var sum = p + q + (r + s); // infinite or NaN if one of them is, which the least and the greatest need not tell
        var lo = Lanes8.MinNative(Lanes8.MinNative(p, q), Lanes8.MinNative(r, s));
        var hi = Lanes8.MaxNative(Lanes8.MaxNative(p, q), Lanes8.MaxNative(r, s));
        return OrAnything(a, b, lo, hi, sum - sum <= 0, gap);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Interval OrAnything(Interval a, Interval b, Lanes8 lo, Lanes8 hi, Lanes8 isFinite, Lanes8 gap)
    {
        var nan = Lanes8.MaxNative(a.NaN, b.NaN);
        return new(
            Lanes8.Select(isFinite, lo, double.NegativeInfinity), Lanes8.Select(isFinite, hi, double.PositiveInfinity),
            Lanes8.Select(isFinite, nan, Lanes8.MaxNative(nan, In(Occurrence.Maybe))), gap);
    }
}
