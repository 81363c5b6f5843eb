using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace RayCaster.Engine;

/// <summary>A <see cref="FloatPacket"/> of two rows of sixteen, for machines that compute with sixteen floats at once.</summary>
/// <param name="lower">The numbers of the lower row.</param>
/// <param name="upper">Those of the upper row.</param>
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
internal readonly struct WideFloatPacket(Vector512<float> lower, Vector512<float> upper) : IFloatPacket<WideFloatPacket>
{
    public readonly Vector512<float> Lower = lower, Upper = upper;

    public static int Count => Vector512<float>.Count;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator WideFloatPacket(double value) => Of(Vector512.Create((float)value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideFloatPacket operator +(WideFloatPacket a, WideFloatPacket b) => new(a.Lower + b.Lower, a.Upper + b.Upper);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideFloatPacket operator -(WideFloatPacket a, WideFloatPacket b) => new(a.Lower - b.Lower, a.Upper - b.Upper);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideFloatPacket operator -(WideFloatPacket a) => new(-a.Lower, -a.Upper);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideFloatPacket operator *(WideFloatPacket a, WideFloatPacket b) => new(a.Lower * b.Lower, a.Upper * b.Upper);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideFloatPacket operator /(WideFloatPacket a, WideFloatPacket b) => new(a.Lower / b.Lower, a.Upper / b.Upper);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideFloatPacket operator <(WideFloatPacket a, WideFloatPacket b) =>
        new(Vector512.LessThan(a.Lower, b.Lower), Vector512.LessThan(a.Upper, b.Upper));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideFloatPacket operator >(WideFloatPacket a, WideFloatPacket b) =>
        new(Vector512.GreaterThan(a.Lower, b.Lower), Vector512.GreaterThan(a.Upper, b.Upper));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideFloatPacket operator <=(WideFloatPacket a, WideFloatPacket b) =>
        new(Vector512.LessThanOrEqual(a.Lower, b.Lower), Vector512.LessThanOrEqual(a.Upper, b.Upper));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideFloatPacket operator >=(WideFloatPacket a, WideFloatPacket b) =>
        new(Vector512.GreaterThanOrEqual(a.Lower, b.Lower), Vector512.GreaterThanOrEqual(a.Upper, b.Upper));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideFloatPacket operator &(WideFloatPacket a, WideFloatPacket b) => new(a.Lower & b.Lower, a.Upper & b.Upper);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideFloatPacket operator |(WideFloatPacket a, WideFloatPacket b) => new(a.Lower | b.Lower, a.Upper | b.Upper);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideFloatPacket Sqrt(WideFloatPacket x) => new(Vector512.Sqrt(x.Lower), Vector512.Sqrt(x.Upper));

    /// <summary>There is no NaN where <see cref="ErrorBound"/> is finite.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideFloatPacket Min(WideFloatPacket a, WideFloatPacket b) =>
        new(Vector512.MinNative(a.Lower, b.Lower), Vector512.MinNative(a.Upper, b.Upper));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideFloatPacket Max(WideFloatPacket a, WideFloatPacket b) =>
        new(Vector512.MaxNative(a.Lower, b.Lower), Vector512.MaxNative(a.Upper, b.Upper));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideFloatPacket Select(WideFloatPacket mask, WideFloatPacket a, WideFloatPacket b) =>
        new(Vector512.ConditionalSelect(mask.Lower, a.Lower, b.Lower), Vector512.ConditionalSelect(mask.Upper, a.Upper, b.Upper));

    [MethodImpl(MethodImplOptions.AggressiveInlining)] // in a large method, the interface's default would not be inlined
    public static WideFloatPacket If(WideFloatPacket mask, WideFloatPacket value) => Select(mask, value, double.NaN);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideFloatPacket Of(Vector512<float> row) => new(row, row);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideFloatPacket Row(float[] numbers, int first) => Of(numbers.Load512(first));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideFloatPacket PerRow(float[] numbers, int first) =>
        new(Vector512.Create(numbers[first]), Vector512.Create(numbers[first + 1]));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideFloatPacket Rows(float[] lower, float[] upper, int first) => new(lower.Load512(first), upper.Load512(first));

    /// <summary>One division and three products, each of which rounds.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3<WideFloatPacket> Divide(Vector3<WideFloatPacket> a, WideFloatPacket b) => (WideFloatPacket)1 / b * a;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideFloatPacket Pixels(WideFloatPacket r, WideFloatPacket g, WideFloatPacket b) =>
        new(FloatBytes.Packed(r.Lower, g.Lower, b.Lower).AsSingle(), FloatBytes.Packed(r.Upper, g.Upper, b.Upper).AsSingle());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public uint WriteRange(WideFloatPacket ends, int background, byte[] rgb, int place, int count)
    {
        var (isMiss, most, least) = (Vector512.Equals(ends.Lower, Vector512<float>.Zero).AsInt32(), Lower.AsInt32(), Upper.AsInt32());
        var pixels = Vector512.ConditionalSelect(isMiss, Vector512.Create(background), least);
        if (count >= Count) FloatBytes.Store(pixels, rgb, place);
        else FloatBytes.StoreFew(pixels, rgb.AsSpan(place, 3 * count));
        return (uint)(Vector512.Equals(least, most) | isMiss).ExtractMostSignificantBits() ^ 0xFFFF;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public uint Write(in FloatLevels levels, byte[] rgb, int lower, int upper)
    {
        var ofUpper = Write(Upper, levels, rgb, upper);
        return Write(Lower, levels, rgb, lower) | (ofUpper << Count);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static uint Write(Vector512<float> t, in FloatLevels levels, byte[] rgb, int place)
    {
        var least = FloatBytes.Packed(levels.Red.Least(t), levels.Green.Least(t), levels.Blue.Least(t));
        var most = FloatBytes.Packed(levels.Red.Most(t), levels.Green.Most(t), levels.Blue.Most(t));
        FloatBytes.Store(least, rgb, place);
        return (uint)Vector512.Equals(least, most).ExtractMostSignificantBits() ^ 0xFFFF;
    }
}
