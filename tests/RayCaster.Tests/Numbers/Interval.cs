namespace RayCaster.Tests.Numbers;

/// <summary>
/// All the numbers from Lo to Hi, and NaN if said so: a formula over it tells what a whole region of rays may do. As a mask 0 is
/// "nowhere", 1 "everywhere" and [0, 1] "unknown". A trial of the door that <see cref="IReal{N}"/> leaves open.
/// </summary>
internal readonly record struct Interval(double Lo, double Hi, bool MayBeNaN = false) : IReal<Interval>
{
    private static readonly Interval Nothing = new(double.PositiveInfinity, double.NegativeInfinity, MayBeNaN: true);
    private static readonly Interval Anything = new(double.NegativeInfinity, double.PositiveInfinity, MayBeNaN: true);

    public bool IsSurelyNaN => Lo > Hi;

    public bool Contains(double x) => double.IsNaN(x) ? MayBeNaN : Lo <= x && x <= Hi;

    public static implicit operator Interval(double value) => double.IsNaN(value) ? Nothing : new(value, value);

    public static Interval operator +(Interval a, Interval b) => Outwards(a, b, [a.Lo + b.Lo, a.Hi + b.Hi]);

    public static Interval operator -(Interval a, Interval b) => Outwards(a, b, [a.Lo - b.Hi, a.Hi - b.Lo]);

    public static Interval operator -(Interval a) => a with { Lo = -a.Hi, Hi = -a.Lo };

    public static Interval operator *(Interval a, Interval b) => Outwards(a, b, [a.Lo * b.Lo, a.Lo * b.Hi, a.Hi * b.Lo, a.Hi * b.Hi]);

    public static Interval operator /(Interval a, Interval b) =>
        b.Lo <= 0 && b.Hi >= 0 && !a.IsSurelyNaN ? Anything : Outwards(a, b, [a.Lo / b.Lo, a.Lo / b.Hi, a.Hi / b.Lo, a.Hi / b.Hi]);

    public static Interval operator <(Interval a, Interval b) => Mask(a, b, a.Hi < b.Lo, a.Lo < b.Hi);

    public static Interval operator >(Interval a, Interval b) => b < a;

    public static Interval operator <=(Interval a, Interval b) => Mask(a, b, a.Hi <= b.Lo, a.Lo <= b.Hi);

    public static Interval operator >=(Interval a, Interval b) => b <= a;

    public static Interval operator &(Interval a, Interval b) => new(Math.Min(a.Lo, b.Lo), Math.Min(a.Hi, b.Hi));

    public static Interval operator |(Interval a, Interval b) => new(Math.Max(a.Lo, b.Lo), Math.Max(a.Hi, b.Hi));

    public static Interval Sqrt(Interval x) =>
        x.IsSurelyNaN || x.Hi < 0 ? Nothing : Outwards(x, x, [Math.Sqrt(Math.Max(0, x.Lo)), Math.Sqrt(x.Hi)]) with { MayBeNaN = x.MayBeNaN || x.Lo < 0 };

    public static Interval Min(Interval a, Interval b) => Both(a, b, Math.Min(a.Lo, b.Lo), Math.Min(a.Hi, b.Hi));

    public static Interval Max(Interval a, Interval b) => Both(a, b, Math.Max(a.Lo, b.Lo), Math.Max(a.Hi, b.Hi));

    public static Interval Select(Interval mask, Interval a, Interval b) =>
        mask.Lo == 1 ? a : mask.Hi == 0 ? b : new(Math.Min(a.Lo, b.Lo), Math.Max(a.Hi, b.Hi), a.MayBeNaN || b.MayBeNaN);

    private static Interval Mask(Interval a, Interval b, bool surely, bool maybe) =>
        a.IsSurelyNaN || b.IsSurelyNaN ? 0 : new Interval(surely && !a.MayBeNaN && !b.MayBeNaN ? 1 : 0, maybe ? 1 : 0);

    private static Interval Both(Interval a, Interval b, double lo, double hi) =>
        a.IsSurelyNaN || b.IsSurelyNaN ? Nothing : new(lo, hi, a.MayBeNaN || b.MayBeNaN);

    /// <summary>The hull of the corners' results, one last bit wider; anything if one of them is NaN, as 0 · ∞ is.</summary>
    private static Interval Outwards(Interval a, Interval b, ReadOnlySpan<double> corners)
    {
        if (a.IsSurelyNaN || b.IsSurelyNaN) return Nothing;
        var (lo, hi) = (double.PositiveInfinity, double.NegativeInfinity);
        foreach (var corner in corners)
        {
            if (double.IsNaN(corner)) return Anything;
            (lo, hi) = (Math.Min(lo, corner), Math.Max(hi, corner));
        }
        return new(Math.BitDecrement(lo), Math.BitIncrement(hi), a.MayBeNaN || b.MayBeNaN);
    }
}
