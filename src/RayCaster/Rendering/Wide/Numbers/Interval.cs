using System.Runtime.CompilerServices;

namespace RayCaster;

/// <summary>
/// All the numbers from Lo to Hi, and NaN if said so: a formula over it tells what all the rays of a part of the picture may do. Each lane is a
/// part of its own. As a mask Lo is where it surely holds, Hi where it may.
/// </summary>
/// <remarks>
/// It holds what doubles compute, not what real numbers would give, so nothing is rounded outwards: each operation is monotonic in each
/// operand, and so is rounding to nearest; what is computed from numbers between two others lies between what is computed from those.
/// Where a divisor may be 0, or an end is infinite or NaN (0 · ∞, ∞ − ∞ and 0 / 0 may then lie between the ends), the answer is "anything".
/// </remarks>
/// <param name="lo">The least number.</param>
/// <param name="hi">The greatest number.</param>
/// <param name="mayBeNaN">A mask: some of the rays may have no number at all.</param>
/// <param name="isNothing">A mask: no ray has a number; the ends mean nothing.</param>
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
internal readonly struct Interval(WidePacket lo, WidePacket hi, WidePacket mayBeNaN, WidePacket isNothing) : IReal<Interval>
{
    public readonly WidePacket Lo = lo, Hi = hi, MayBeNaN = mayBeNaN, IsNothing = isNothing;

    private static WidePacket Yes
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => (WidePacket)0 <= 0;
    }

    private static WidePacket No
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => 0;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Interval(WidePacket lo, WidePacket hi) : this(lo, hi, No, No) { }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator Interval(double value) =>
        double.IsNaN(value) ? new(double.PositiveInfinity, double.NegativeInfinity, Yes, Yes) : new(value, value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Interval operator +(Interval a, Interval b) => Finite(a, b, a.Lo + b.Lo, a.Hi + b.Hi);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Interval operator -(Interval a, Interval b) => Finite(a, b, a.Lo - b.Hi, a.Hi - b.Lo);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Interval operator -(Interval a) => new(-a.Hi, -a.Lo, a.MayBeNaN, a.IsNothing);

    public static Interval operator *(Interval a, Interval b) => Hull(a, b, a.Lo * b.Lo, a.Lo * b.Hi, a.Hi * b.Lo, a.Hi * b.Hi);

    public static Interval operator /(Interval a, Interval b)
    {
        // A quotient by NaN is NaN, which Finite takes for anything.
        var divisor = WidePacket.Select((b.Lo <= 0) & (b.Hi >= 0), double.NaN, b.Lo);
        return Hull(a, b, a.Lo / divisor, a.Lo / b.Hi, a.Hi / divisor, a.Hi / b.Hi);
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
    public static Interval Sqrt(Interval x) => new(WidePacket.Sqrt(WidePacket.Greater(0, x.Lo)), WidePacket.Sqrt(x.Hi), x.MayBeNaN | (x.Lo < 0), x.IsNothing | (x.Hi < 0));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Interval Min(Interval a, Interval b) =>
        new(WidePacket.Lesser(a.Lo, b.Lo), WidePacket.Lesser(a.Hi, b.Hi), a.MayBeNaN | b.MayBeNaN, a.IsNothing | b.IsNothing);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Interval Max(Interval a, Interval b) =>
        new(WidePacket.Greater(a.Lo, b.Lo), WidePacket.Greater(a.Hi, b.Hi), a.MayBeNaN | b.MayBeNaN, a.IsNothing | b.IsNothing);

    public static Interval Select(Interval mask, Interval a, Interval b)
    {
        // Either: the hull of what there is.
        WidePacket least = double.PositiveInfinity, most = double.NegativeInfinity;
        var lo = WidePacket.Lesser(WidePacket.Select(a.IsNothing, least, a.Lo), WidePacket.Select(b.IsNothing, least, b.Lo));
        var hi = WidePacket.Greater(WidePacket.Select(a.IsNothing, most, a.Hi), WidePacket.Select(b.IsNothing, most, b.Hi));
        return new(
            Choose(a.Lo, lo, b.Lo), Choose(a.Hi, hi, b.Hi),
            Choose(a.MayBeNaN, a.MayBeNaN | b.MayBeNaN, b.MayBeNaN), Choose(a.IsNothing, a.IsNothing & b.IsNothing, b.IsNothing));

        WidePacket Choose(WidePacket surely, WidePacket either, WidePacket surelyNot) => WidePacket.Select(mask.Lo, surely, WidePacket.Select(mask.Hi, either, surelyNot));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Interval Mask(Interval a, Interval b, WidePacket surely, WidePacket maybe)
    {
        var isNothing = a.IsNothing | b.IsNothing;
        return new(WidePacket.Select(isNothing | a.MayBeNaN | b.MayBeNaN, No, surely), WidePacket.Select(isNothing, No, maybe));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Interval Hull(Interval a, Interval b, WidePacket p, WidePacket q, WidePacket r, WidePacket s)
    {
        var sum = p + q + (r + s); // infinite or NaN if one of them is, of which the least and the greatest may tell nothing
        return OrAnything(a, b, WidePacket.Lesser(WidePacket.Lesser(p, q), WidePacket.Lesser(r, s)), WidePacket.Greater(WidePacket.Greater(p, q), WidePacket.Greater(r, s)), sum - sum <= 0);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Interval Finite(Interval a, Interval b, WidePacket lo, WidePacket hi) =>
        OrAnything(a, b, lo, hi, hi - lo < double.PositiveInfinity); // false for NaN

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Interval OrAnything(Interval a, Interval b, WidePacket lo, WidePacket hi, WidePacket isFinite) => new(
        WidePacket.Select(isFinite, lo, double.NegativeInfinity), WidePacket.Select(isFinite, hi, double.PositiveInfinity),
        WidePacket.Select(isFinite, a.MayBeNaN | b.MayBeNaN, Yes), a.IsNothing | b.IsNothing);
}
