using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace RayCaster.Engine;

/// <summary>
/// Three quotients by one divisor, each rounded as the processor's own division rounds, but without it: a machine that multiplies sixteen doubles in
/// a
/// cycle may take sixteen cycles to divide eight (after Markstein, "Computation of Elementary Functions on the IBM RISC System/6000 Processor",
/// 1990).
/// </summary>
/// <remarks>
/// <para>Let u = 2⁻⁵³, and 1 ≤ b &lt; 2 and 1 ≤ a / b &lt; 2, for powers of two change nothing while no number is too large or too small. Every
/// fused
/// step rounds once.</para>
/// <para>The reciprocal y is known to 2⁻¹⁴. A step to y + y e, where e = 1 − b y, leaves e² of the error e and ends below 1 / b: by 2⁻²⁸, then by
/// u /
/// 8, where rounding upwards makes of it no more than 2 u. So the third
/// e is exact, 4 u² are left of it, and y is a double next to 1 / b: |b y − 1| ≤ b u / 2 + 4 u². Where b is within 100 u of 2 the 4 u² do not count.
/// If its digits are all 1, b = 2 − 2 u, then 1 / b is only u² / 2 above the middle of
/// two doubles, and a y that was rounded downwards before would end on that middle; rounded upwards it is the right one already.</para>
/// <para>Now q = a y, mended by y times the rest a − b q. If that rounded to another double than a / b does, the middle m of the two would be as
/// near
/// to a / b as the unrounded sum is, and that is very near, less than 8 u²: then q, which
/// is the double nearest to something less than 2 u away, is one of the two, its rest is exact (a multiple of 4 u², and less than 2⁵³ of them) and
/// over b no more than u + 8 u², and the sum is off by less than b u² / 2 (1 + 17 u), or no more
/// than u² where b is near 2. But a − b m is a multiple of 2 u², and not 0: m is not nearer than 2 u² / b, which is more, as b ≤ 2 − 2 u.</para>
/// </remarks>
internal static class Quotients
{
    /// <summary>The exponent of 2⁻²⁵⁵ in its place, and the bits of an exponent that is less, or more than 511 greater, once that one is
    /// subtracted.</summary>
    private const long Least = 768L << 52, Beyond = 3L << 61;

    /// <summary>a / b, each lane and each coordinate rounded once.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3<WidePacket> Divide(Vector3<WidePacket> a, WidePacket b)
    {
        // A call for the rare case would cost the loops around their registers.
        if (!Avx512F.IsSupported || !AreMiddling(a.X.Lanes, a.Y.Lanes, a.Z.Lanes, b.Lanes)) return new(a.X / b, a.Y / b, a.Z / b);
        var y = Reciprocal(b.Lanes);
        return new(Quotient(a.X.Lanes, b.Lanes, y), Quotient(a.Y.Lanes, b.Lanes, y), Quotient(a.Z.Lanes, b.Lanes, y));
    }

    /// <summary>Whether nothing can become too small or too large: 2⁻²⁵⁵ ≤ |x| &lt; 2²⁵⁷. Neither 0, whose sign would be lost, nor infinite numbers
    /// nor NaN are.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool AreMiddling(Vector512<double> x, Vector512<double> y, Vector512<double> z, Vector512<double> b)
    {
        var least = Vector512.Create(Least);
        var exponents = (x.AsInt64() - least) | (y.AsInt64() - least) | (z.AsInt64() - least) | (b.AsInt64() - least);
        return (exponents & Vector512.Create(Beyond)) == Vector512<long>.Zero;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> Reciprocal(Vector512<double> b)
    {
        var one = Vector512.Create(1.0);
        var y = Avx512F.Reciprocal14(b);
        y = Avx512F.FusedMultiplyAdd(y, Avx512F.FusedMultiplyAddNegated(b, y, one), y);
        y = Avx512F.FusedMultiplyAdd(y, Avx512F.FusedMultiplyAddNegated(b, y, one), y, FloatRoundingMode.ToPositiveInfinity);
        return Avx512F.FusedMultiplyAdd(y, Avx512F.FusedMultiplyAddNegated(b, y, one), y);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WidePacket Quotient(Vector512<double> a, Vector512<double> b, Vector512<double> y)
    {
        var q = a * y;
        return new() { Lanes = Avx512F.FusedMultiplyAdd(y, Avx512F.FusedMultiplyAddNegated(b, q, a), q) };
    }
}
