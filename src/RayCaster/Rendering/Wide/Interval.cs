namespace RayCaster;

/// <summary>
/// All the numbers from Lo to Hi, and NaN if said so: a formula over it tells what a whole tile of rays may do. As a mask 0 is
/// "nowhere", 1 "everywhere" and [0, 1] "unknown".
/// </summary>
/// <remarks>
/// It holds what doubles compute, not what real numbers would give, so nothing is rounded outwards: each operation is monotonic in each
/// operand, and so is rounding to nearest; what is computed from numbers between two others lies between what is computed from those.
/// Where a divisor may be 0, or an end is infinite or NaN (0 · ∞, ∞ − ∞ and 0 / 0 may then lie between the ends), the answer is "anything".
/// </remarks>
/// <param name="Lo">The least number; more than Hi if there is none.</param>
/// <param name="Hi">The greatest number.</param>
/// <param name="MayBeNaN">Whether some of the rays may have no number at all.</param>
internal readonly record struct Interval(double Lo, double Hi, bool MayBeNaN = false) : IReal<Interval>
{
    private static Interval Nothing => new(double.PositiveInfinity, double.NegativeInfinity, MayBeNaN: true);

    private static Interval Anything => new(double.NegativeInfinity, double.PositiveInfinity, MayBeNaN: true);

    /// <summary>Whether there is no number: no ray of the tile has what was asked for.</summary>
    public bool IsSurelyNaN => Lo > Hi;

    public bool Contains(double x) => double.IsNaN(x) ? MayBeNaN : Lo <= x && x <= Hi;

    public static implicit operator Interval(double value) => double.IsNaN(value) ? Nothing : new(value, value);

    public static Interval operator +(Interval a, Interval b) => Checked(a, b, a.Lo + b.Lo, a.Hi + b.Hi);

    public static Interval operator -(Interval a, Interval b) => Checked(a, b, a.Lo - b.Hi, a.Hi - b.Lo);

    public static Interval operator -(Interval a) => new(-a.Hi, -a.Lo, a.MayBeNaN);

    public static Interval operator *(Interval a, Interval b) => Hull(a, b, a.Lo * b.Lo, a.Lo * b.Hi, a.Hi * b.Lo, a.Hi * b.Hi);

    public static Interval operator /(Interval a, Interval b) => b.Lo <= 0 && b.Hi >= 0
        ? a.IsSurelyNaN ? Nothing : Anything
        : Hull(a, b, a.Lo / b.Lo, a.Lo / b.Hi, a.Hi / b.Lo, a.Hi / b.Hi);

    public static Interval operator <(Interval a, Interval b) => Mask(a, b, a.Hi < b.Lo, a.Lo < b.Hi);

    public static Interval operator >(Interval a, Interval b) => Mask(a, b, a.Lo > b.Hi, a.Hi > b.Lo);

    public static Interval operator <=(Interval a, Interval b) => Mask(a, b, a.Hi <= b.Lo, a.Lo <= b.Hi);

    public static Interval operator >=(Interval a, Interval b) => Mask(a, b, a.Lo >= b.Hi, a.Hi >= b.Lo);

    public static Interval operator &(Interval a, Interval b) => new(Math.Min(a.Lo, b.Lo), Math.Min(a.Hi, b.Hi));

    public static Interval operator |(Interval a, Interval b) => new(Math.Max(a.Lo, b.Lo), Math.Max(a.Hi, b.Hi));

    public static Interval Sqrt(Interval x) => x.IsSurelyNaN || x.Hi < 0
        ? Nothing
        : new(Math.Sqrt(Math.Max(0, x.Lo)), Math.Sqrt(x.Hi), x.MayBeNaN || x.Lo < 0);

    public static Interval Min(Interval a, Interval b) => a.IsSurelyNaN || b.IsSurelyNaN
        ? Nothing
        : new(Math.Min(a.Lo, b.Lo), Math.Min(a.Hi, b.Hi), a.MayBeNaN || b.MayBeNaN);

    public static Interval Max(Interval a, Interval b) => a.IsSurelyNaN || b.IsSurelyNaN
        ? Nothing
        : new(Math.Max(a.Lo, b.Lo), Math.Max(a.Hi, b.Hi), a.MayBeNaN || b.MayBeNaN);

    public static Interval Select(Interval mask, Interval a, Interval b) =>
        mask.Lo == 1 ? a : mask.Hi == 0 ? b : new(Math.Min(a.Lo, b.Lo), Math.Max(a.Hi, b.Hi), a.MayBeNaN || b.MayBeNaN);

    private static Interval Mask(Interval a, Interval b, bool surely, bool maybe) => a.IsSurelyNaN || b.IsSurelyNaN
        ? 0
        : new Interval(surely && !a.MayBeNaN && !b.MayBeNaN ? 1 : 0, maybe ? 1 : 0);

    private static Interval Hull(Interval a, Interval b, double p, double q, double r, double s) =>
        Checked(a, b, Math.Min(Math.Min(p, q), Math.Min(r, s)), Math.Max(Math.Max(p, q), Math.Max(r, s)));

    private static Interval Checked(Interval a, Interval b, double lo, double hi) =>
        a.IsSurelyNaN || b.IsSurelyNaN ? Nothing
        : !double.IsFinite(lo) || !double.IsFinite(hi) ? Anything
        : new(lo, hi, a.MayBeNaN || b.MayBeNaN);
}
