namespace RayCaster.Engine;

/// <summary>
/// What doubles compute, as an interval, and how far from it floats can be: a formula over it bounds the error of the same formula over
/// <see cref="FloatPacket"/> for every ray of a part of the picture at once. As a mask it is 1 or 0 only where doubles and floats agree on all rays.
/// </summary>
/// <remarks>
/// Each operation passes on the errors of its operands and adds what rounding its own result adds: half a unit in the last place of a float, 2⁻²⁴ of
/// its size, or 2⁻¹⁴⁹ for numbers too small for that. Doubles, and these bounds, round by 2⁻⁵³; <see cref="HalfUlp"/> is a little larger
/// to cover that. An infinite error means that nothing is known. (An <see cref="Interval"/> knows more of NaN and of infinite numbers; where one
/// of these may occur, floats are not used.)
/// </remarks>
/// <param name="Lo">The least that doubles compute.</param>
/// <param name="Hi">The greatest.</param>
/// <param name="Error">No float is farther from its double than this.</param>
internal readonly record struct ErrorBound(double Lo, double Hi, double Error) : IReal<ErrorBound>
{
    private const double HalfUlp = 1.000001 / (1 << 24);
    private const double Least = 1.5e-45;
    private const double Most = 1e38;

    private static ErrorBound Unknown => new(double.NegativeInfinity, double.PositiveInfinity, double.PositiveInfinity);

    private static ErrorBound Unsure => new(0, 1, 0);

    private double Size => Max(-Lo, Hi);

    public static ErrorBound From(double lo, double hi) => Result(lo, hi, 0);

    // infinite in both
    public static implicit operator ErrorBound(double value) => Math.Abs(value) >= double.MaxValue ? new(value, value, 0) : From(value, value);

    public static ErrorBound operator +(ErrorBound a, ErrorBound b) => Result(a.Lo + b.Lo, a.Hi + b.Hi, a.Error + b.Error);

    public static ErrorBound operator -(ErrorBound a, ErrorBound b) => Result(a.Lo - b.Hi, a.Hi - b.Lo, a.Error + b.Error);

    public static ErrorBound operator -(ErrorBound a) => new(-a.Hi, -a.Lo, a.Error);

    public static ErrorBound operator *(ErrorBound a, ErrorBound b) =>
        Result(a.Lo * b.Lo, a.Lo * b.Hi, a.Hi * b.Lo, a.Hi * b.Hi, a.Size * b.Error + b.Size * a.Error + a.Error * b.Error);

    /// <summary>With a' and b' for the floats, a' / b' − a / b = ((a' − a) − (b' − b) a / b) / b'.</summary>
    public static ErrorBound operator /(ErrorBound a, ErrorBound b)
    {
        var leastDivisor = Max(b.Lo, -b.Hi) - b.Error;
        if (!(leastDivisor > 0)) return Unknown;
        var exact = Result(a.Lo / b.Lo, a.Lo / b.Hi, a.Hi / b.Lo, a.Hi / b.Hi, 0);
        return Result(exact.Lo, exact.Hi, (a.Error + b.Error * exact.Size) / leastDivisor);
    }

    public static ErrorBound operator <(ErrorBound a, ErrorBound b) => IsBelow(a, b) ? 1 : IsBelow(b, a) ? 0 : Unsure;

    public static ErrorBound operator >(ErrorBound a, ErrorBound b) => b < a;

    public static ErrorBound operator <=(ErrorBound a, ErrorBound b) => a < b;

    public static ErrorBound operator >=(ErrorBound a, ErrorBound b) => b < a;

    public static ErrorBound operator &(ErrorBound a, ErrorBound b) => Min(a, b);

    public static ErrorBound operator |(ErrorBound a, ErrorBound b) => Max(a, b);

    /// <summary>√a' − √a = (a' − a) / (√a' + √a).</summary>
    public static ErrorBound Sqrt(ErrorBound x)
    {
        var least = x.Lo - x.Error;
        return least > 0 ? Result(Math.Sqrt(x.Lo), Math.Sqrt(x.Hi), x.Error / (Math.Sqrt(least) + Math.Sqrt(x.Lo))) : Unknown;
    }

    /// <summary>The lesser of two moves no farther than the one that moves farther; and it is not rounded.</summary>
    public static ErrorBound Min(ErrorBound a, ErrorBound b) => new(Min(a.Lo, b.Lo), Min(a.Hi, b.Hi), Max(a.Error, b.Error));

    public static ErrorBound Max(ErrorBound a, ErrorBound b) => new(Max(a.Lo, b.Lo), Max(a.Hi, b.Hi), Max(a.Error, b.Error));

    public static ErrorBound Select(ErrorBound mask, ErrorBound a, ErrorBound b) => mask.Lo == 1 ? a : mask.Hi == 0 ? b : Unknown;

    /// <summary>As <see cref="FloatPacket.Divide"/> does it.</summary>
    public static Vector3<ErrorBound> Divide(Vector3<ErrorBound> a, ErrorBound b)
    {
        var inverse = (ErrorBound)1 / b;
        return new(Mended(a.X, b, inverse), Mended(a.Y, b, inverse), Mended(a.Z, b, inverse));

        // Doubles divide; the product with the reciprocal differs by at most 2⁻⁵² of it.
        static ErrorBound Mended(ErrorBound a, ErrorBound b, ErrorBound inverse)
        {
            var exact = a / b;
            return exact with { Error = Max((a * inverse).Error, exact.Error) };
        }
    }

    /// <summary>Whether every a is less than every b, for doubles and for floats.</summary>
    private static bool IsBelow(ErrorBound a, ErrorBound b) => a.Hi + a.Error < b.Lo - b.Error;

    private static ErrorBound Result(double p, double q, double r, double s, double error) =>
        Result(Min(Min(p, q), Min(r, s)), Max(Max(p, q), Max(r, s)), error);

    private static ErrorBound Result(double lo, double hi, double error)
    {
        var size = Max(-lo, hi) + error;
        return size < Most ? new(lo, hi, error + size * HalfUlp + Least) : Unknown;
    }

    // There is no NaN here: all numbers are less than a float can be, or the error is infinite.
    private static double Min(double a, double b) => double.MinNative(a, b);

    private static double Max(double a, double b) => double.MaxNative(a, b);
}
