using System.Runtime.Intrinsics;

namespace RayCaster.Engine.Tests.Numbers;

/// <summary>Quotients by a common divisor have the bits that division gives.</summary>
public class QuotientsTests
{
    private readonly Random random = new(1990);

    [Fact]
    public void QuotientsNextToTheMiddleOfTwoDoublesRoundAsDivisionDoes()
    {
        for (var i = 0; i < 40_000; i++) Compare(Enumerable.Range(0, 8).Select(_ => NextToAMiddle(Significand())));
    }

    [Fact]
    public void SoDoTheyForDivisorsNextToAPowerOfTwo()
    {
        for (var beta = 1L; beta < 2000; beta += 2)
        {
            Compare(Enumerable.Range(0, 8).Select(_ => NextToAMiddle((1L << 53) - beta)));
            Compare(Enumerable.Range(0, 8).Select(_ => NextToAMiddle((1L << 52) + beta)));
            Compare(Enumerable.Range(0, 8).Select(i => ((double)(1L << 52) + (i - 4), (double)((1L << 53) - beta))));
        }
    }

    [Fact]
    public void QuotientsOfAllSizesAndSignsAreThoseOfDivision()
    {
        for (var i = 0; i < 60_000; i++) Compare(Enumerable.Range(0, 8).Select(_ => (OfAnySize(), OfAnySize())));
    }

    [Fact]
    public void SoAreThoseOfZerosInfinitiesAndTheLeastAndGreatestNumbers()
    {
        double[] special =
        [
            0, -0.0, 1, -1, double.NaN, double.PositiveInfinity, double.NegativeInfinity, double.Epsilon, -double.Epsilon, double.MaxValue,
            2.2250738585072014e-308,
            1e-150, 1e150, Math.BitDecrement(1e-150), Math.BitIncrement(1e150), 1e-200, 1e200, 1e-308, 1e308,
            // where products end and begin
            Math.ScaleB(1, -255), Math.BitDecrement(Math.ScaleB(1, -255)), Math.ScaleB(1, 257), Math.BitDecrement(Math.ScaleB(1, 257)),
        ];
        foreach (var a in special)
            foreach (var b in special)
            {
                Compare(Enumerable.Repeat((a, b), 8));
                Compare(Enumerable.Range(0, 8).Select(i => i == 3 ? (a, b) : (OfMiddlingSize(), OfMiddlingSize()))); // one lane among others
            }
    }

    /// <summary>
    /// a and b of which a / b lies as near to the middle m of two doubles as can be, or nearly so: with whole b and m of 53 and 54 digits
    /// 2⁵⁴ a = b m + r has a solution for each odd b and small odd r, by the inverse of b.
    /// </summary>
    private (double A, double B) NextToAMiddle(long b)
    {
        b |= 1;
        for (var r = 2 * random.NextInt64(0, 8) + 1; ; r = 2 * random.NextInt64(0, 1000) + 1)
        {
            if (random.Next(2) == 0) r = -r;
            var inverse = b; // modulo 8; each step doubles the digits
            for (var i = 0; i < 5; i++) inverse *= 2 - b * inverse;
            var m = (-r * inverse) & ((1L << 54) - 1);
            var a = (long)(((Int128)b * m + r) >> 54);
            if (m >> 53 == 1 && a < 1L << 53) return (a, b);
        }
    }

    private long Significand() => random.NextInt64(1L << 52, 1L << 53);

    private double OfMiddlingSize() => (random.Next(2) * 2 - 1) * Math.ScaleB(Significand(), random.Next(-300, 200));

    private double OfAnySize() => BitConverter.Int64BitsToDouble(random.NextInt64(long.MinValue, long.MaxValue));

    private static void Compare(IEnumerable<(double A, double B)> eight)
    {
        var pairs = eight.ToArray(); // once: they are made at random
        var (a, b) = (Array.ConvertAll(pairs, pair => pair.A), Array.ConvertAll(pairs, pair => pair.B));
        var (x, d) = (new WidePacket(Vector512.Create<double>(a)), new WidePacket(Vector512.Create<double>(b)));
        var quotients = WidePacket.Divide(new(x, -x, x * 4), d);
        for (var i = 0; i < 8; i++)
        {
            AssertSame(a[i] / b[i], quotients.X.Lanes[i], a[i], b[i]);
            AssertSame(-a[i] / b[i], quotients.Y.Lanes[i], -a[i], b[i]);
            AssertSame(a[i] * 4 / b[i], quotients.Z.Lanes[i], a[i] * 4, b[i]);
        }
    }

    private static void AssertSame(double expected, double actual, double a, double b) => Assert.True(
        expected.Equals(actual) && double.IsNegative(expected) == double.IsNegative(actual) || double.IsNaN(expected) && double.IsNaN(actual),
        $"{a:R} / {b:R} is {expected:R}, not {actual:R}");
}
