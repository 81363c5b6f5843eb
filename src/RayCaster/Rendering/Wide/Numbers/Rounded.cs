namespace RayCaster;

/// <summary>
/// What doubles compute, as an interval, and how far from it floats can be: a formula over it bounds the error of the same formula over
/// <see cref="RoughPacket"/> for every ray of a part of the picture at once. As a mask it is sure only where doubles and floats agree on all rays.
/// </summary>
/// <remarks>
/// Each operation passes on the errors of its operands and adds what rounding its own result adds: half a unit in the last place of a float, 2⁻²⁴ of its
/// size, or 2⁻¹⁴⁹ for numbers too small for that. Doubles round, too, by 2⁻⁵³, and so do these bounds; that is what <see cref="Unit"/> is a little larger for.
/// An infinite error means that nothing is known.
/// </remarks>
/// <param name="Exact">What doubles compute.</param>
/// <param name="Error">No float is farther from its double than this.</param>
internal readonly record struct Rounded(Interval<Scalar> Exact, double Error) : IReal<Rounded>
{
    private const double Unit = 1.000001 / (1 << 24);
    private const double Least = 1.5e-45;
    private const double Most = 1e38;

    private static Rounded Unknown => new(new(double.NegativeInfinity, double.PositiveInfinity, 1, 0), double.PositiveInfinity);

    private double Lo => Exact.Lo;

    private double Hi => Exact.Hi;

    /// <summary>The greatest absolute value.</summary>
    private double Size => Math.Max(-Lo, Hi);

    /// <summary>Doubles that are rounded to floats.</summary>
    public static Rounded From(Interval<Scalar> exact) => Result(exact, 0);

    public static implicit operator Rounded(double value) => Math.Abs(value) >= double.MaxValue ? new(value, 0) : From(value); // infinite in both

    public static Rounded operator +(Rounded a, Rounded b) => Result(a.Exact + b.Exact, a.Error + b.Error);

    public static Rounded operator -(Rounded a, Rounded b) => Result(a.Exact - b.Exact, a.Error + b.Error);

    public static Rounded operator -(Rounded a) => new(-a.Exact, a.Error);

    public static Rounded operator *(Rounded a, Rounded b) =>
        Result(a.Exact * b.Exact, a.Size * b.Error + b.Size * a.Error + a.Error * b.Error);

    /// <summary>With a' and b' for the floats, a' / b' − a / b = ((a' − a) − (b' − b) a / b) / b'.</summary>
    public static Rounded operator /(Rounded a, Rounded b)
    {
        var leastDivisor = Math.Max(b.Lo, -b.Hi) - b.Error;
        if (!(leastDivisor > 0)) return Unknown;
        var exact = a.Exact / b.Exact;
        return Result(exact, (a.Error + b.Error * Math.Max(-exact.Lo, exact.Hi)) / leastDivisor);
    }

    public static Rounded operator <(Rounded a, Rounded b) => Mask(a, b, Below(a, b), Below(b, a));

    public static Rounded operator >(Rounded a, Rounded b) => Mask(a, b, Below(b, a), Below(a, b));

    public static Rounded operator <=(Rounded a, Rounded b) => Mask(a, b, Below(a, b), Below(b, a));

    public static Rounded operator >=(Rounded a, Rounded b) => Mask(a, b, Below(b, a), Below(a, b));

    public static Rounded operator &(Rounded a, Rounded b) => new(a.Exact & b.Exact, 0);

    public static Rounded operator |(Rounded a, Rounded b) => new(a.Exact | b.Exact, 0);

    /// <summary>√a' − √a = (a' − a) / (√a' + √a).</summary>
    public static Rounded Sqrt(Rounded x)
    {
        var least = x.Lo - x.Error;
        return least > 0 ? Result(Interval<Scalar>.Sqrt(x.Exact), x.Error / (Math.Sqrt(least) + Math.Sqrt(x.Lo))) : Unknown;
    }

    /// <summary>The lesser of two moves no farther than the one that moves farther; and it is not rounded.</summary>
    public static Rounded Min(Rounded a, Rounded b) => new(Interval<Scalar>.Min(a.Exact, b.Exact), Math.Max(a.Error, b.Error));

    public static Rounded Max(Rounded a, Rounded b) => new(Interval<Scalar>.Max(a.Exact, b.Exact), Math.Max(a.Error, b.Error));

    public static Rounded Select(Rounded mask, Rounded a, Rounded b) => mask.Exact.Lo == 1 ? a : mask.Exact.Hi == 0 ? b : Unknown;

    /// <summary>As <see cref="RoughPacket.Divide"/> does it.</summary>
    public static Vector3<Rounded> Divide(Vector3<Rounded> a, Rounded b)
    {
        var inverse = (Rounded)1 / b;
        return new(Mended(a.X, b, inverse), Mended(a.Y, b, inverse), Mended(a.Z, b, inverse));

        // Doubles divide; that the product with the reciprocal is another double is a matter of 2⁻⁵².
        static Rounded Mended(Rounded a, Rounded b, Rounded inverse) => (a * inverse) with { Exact = a.Exact / b.Exact };
    }

    /// <summary>Whether every a is less than every b, for doubles and for floats.</summary>
    private static bool Below(Rounded a, Rounded b) => a.Hi + a.Error < b.Lo - b.Error;

    private static Rounded Mask(Rounded a, Rounded b, bool surely, bool surelyNot) =>
        new(a.Exact.MayBeNaN != 0 || b.Exact.MayBeNaN != 0 ? new(0, 1) : surely ? 1 : surelyNot ? 0 : new Interval<Scalar>(0, 1), 0);

    private static Rounded Result(Interval<Scalar> exact, double error)
    {
        var size = Math.Max(-exact.Lo, exact.Hi) + error;
        return size < Most && exact.MayBeNaN == 0 && exact.IsNothing == 0 ? new(exact, error + size * Unit + Least) : Unknown;
    }
}
