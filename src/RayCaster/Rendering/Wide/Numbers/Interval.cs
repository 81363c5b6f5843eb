using System.Runtime.CompilerServices;

namespace RayCaster;

/// <summary>
/// All the numbers from Lo to Hi, and NaN if said so: a formula over it tells what all the rays of a part of the picture may do; over packets each lane is a
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
/// <typeparam name="N">The numbers of the ends.</typeparam>
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
internal readonly struct Interval<N>(N lo, N hi, N mayBeNaN, N isNothing) : IReal<Interval<N>> where N : struct, IReal<N>
{
    public readonly N Lo = lo, Hi = hi, MayBeNaN = mayBeNaN, IsNothing = isNothing;

    private static N Yes
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => (N)0 <= 0;
    }

    private static N No
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => 0;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Interval(N lo, N hi) : this(lo, hi, No, No) { }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator Interval<N>(double value) =>
        double.IsNaN(value) ? new(double.PositiveInfinity, double.NegativeInfinity, Yes, Yes) : new(value, value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Interval<N> operator +(Interval<N> a, Interval<N> b) => Finite(a, b, a.Lo + b.Lo, a.Hi + b.Hi);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Interval<N> operator -(Interval<N> a, Interval<N> b) => Finite(a, b, a.Lo - b.Hi, a.Hi - b.Lo);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Interval<N> operator -(Interval<N> a) => new(-a.Hi, -a.Lo, a.MayBeNaN, a.IsNothing);

    public static Interval<N> operator *(Interval<N> a, Interval<N> b) => Hull(a, b, a.Lo * b.Lo, a.Lo * b.Hi, a.Hi * b.Lo, a.Hi * b.Hi);

    public static Interval<N> operator /(Interval<N> a, Interval<N> b)
    {
        // A quotient by NaN is NaN, which Finite takes for anything.
        var divisor = N.Select((b.Lo <= 0) & (b.Hi >= 0), double.NaN, b.Lo);
        return Hull(a, b, a.Lo / divisor, a.Lo / b.Hi, a.Hi / divisor, a.Hi / b.Hi);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Interval<N> operator <(Interval<N> a, Interval<N> b) => Mask(a, b, a.Hi < b.Lo, a.Lo < b.Hi);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Interval<N> operator >(Interval<N> a, Interval<N> b) => Mask(a, b, a.Lo > b.Hi, a.Hi > b.Lo);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Interval<N> operator <=(Interval<N> a, Interval<N> b) => Mask(a, b, a.Hi <= b.Lo, a.Lo <= b.Hi);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Interval<N> operator >=(Interval<N> a, Interval<N> b) => Mask(a, b, a.Lo >= b.Hi, a.Hi >= b.Lo);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Interval<N> operator &(Interval<N> a, Interval<N> b) => new(a.Lo & b.Lo, a.Hi & b.Hi);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Interval<N> operator |(Interval<N> a, Interval<N> b) => new(a.Lo | b.Lo, a.Hi | b.Hi);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Interval<N> Sqrt(Interval<N> x) => new(N.Sqrt(N.Max(0, x.Lo)), N.Sqrt(x.Hi), x.MayBeNaN | (x.Lo < 0), x.IsNothing | (x.Hi < 0));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Interval<N> Min(Interval<N> a, Interval<N> b) =>
        new(N.Min(a.Lo, b.Lo), N.Min(a.Hi, b.Hi), a.MayBeNaN | b.MayBeNaN, a.IsNothing | b.IsNothing);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Interval<N> Max(Interval<N> a, Interval<N> b) =>
        new(N.Max(a.Lo, b.Lo), N.Max(a.Hi, b.Hi), a.MayBeNaN | b.MayBeNaN, a.IsNothing | b.IsNothing);

    public static Interval<N> Select(Interval<N> mask, Interval<N> a, Interval<N> b)
    {
        // Either: the hull of what there is.
        N least = double.PositiveInfinity, most = double.NegativeInfinity;
        var lo = N.Min(N.Select(a.IsNothing, least, a.Lo), N.Select(b.IsNothing, least, b.Lo));
        var hi = N.Max(N.Select(a.IsNothing, most, a.Hi), N.Select(b.IsNothing, most, b.Hi));
        return new(
            Choose(a.Lo, lo, b.Lo), Choose(a.Hi, hi, b.Hi),
            Choose(a.MayBeNaN, a.MayBeNaN | b.MayBeNaN, b.MayBeNaN), Choose(a.IsNothing, a.IsNothing & b.IsNothing, b.IsNothing));

        N Choose(N surely, N either, N surelyNot) => N.Select(mask.Lo, surely, N.Select(mask.Hi, either, surelyNot));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Interval<N> Mask(Interval<N> a, Interval<N> b, N surely, N maybe)
    {
        var isNothing = a.IsNothing | b.IsNothing;
        return new(N.Select(isNothing | a.MayBeNaN | b.MayBeNaN, No, surely), N.Select(isNothing, No, maybe));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Interval<N> Hull(Interval<N> a, Interval<N> b, N p, N q, N r, N s) =>
        Finite(a, b, N.Min(N.Min(p, q), N.Min(r, s)), N.Max(N.Max(p, q), N.Max(r, s)));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Interval<N> Finite(Interval<N> a, Interval<N> b, N lo, N hi)
    {
        var isFinite = hi - lo < double.PositiveInfinity; // false for NaN
        return new(
            N.Select(isFinite, lo, double.NegativeInfinity), N.Select(isFinite, hi, double.PositiveInfinity),
            N.Select(isFinite, a.MayBeNaN | b.MayBeNaN, Yes), a.IsNothing | b.IsNothing);
    }
}
