namespace RayCaster.Engine;

// The build makes WideFloatPacket of this file, with vectors of twice the length (RayCaster.Engine.csproj).

/// <summary>Two rows of floats.</summary>
/// <param name="lower">The numbers of the lower row.</param>
/// <param name="upper">Those of the upper row.</param>
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
internal readonly struct FloatPacket(Vector256<float> lower, Vector256<float> upper) : IFloatPacket<FloatPacket>
{
    public readonly Vector256<float> Lower = lower, Upper = upper;

    public static int Count => Vector256<float>.Count;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator FloatPacket(double value) => Of(Vector256.Create((float)value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket operator +(FloatPacket a, FloatPacket b) => new(a.Lower + b.Lower, a.Upper + b.Upper);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket operator -(FloatPacket a, FloatPacket b) => new(a.Lower - b.Lower, a.Upper - b.Upper);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket operator -(FloatPacket a) => new(-a.Lower, -a.Upper);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket operator *(FloatPacket a, FloatPacket b) => new(a.Lower * b.Lower, a.Upper * b.Upper);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket operator /(FloatPacket a, FloatPacket b) => new(a.Lower / b.Lower, a.Upper / b.Upper);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket operator <(FloatPacket a, FloatPacket b) =>
        new(Vector256.LessThan(a.Lower, b.Lower), Vector256.LessThan(a.Upper, b.Upper));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket operator >(FloatPacket a, FloatPacket b) =>
        new(Vector256.GreaterThan(a.Lower, b.Lower), Vector256.GreaterThan(a.Upper, b.Upper));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket operator <=(FloatPacket a, FloatPacket b) =>
        new(Vector256.LessThanOrEqual(a.Lower, b.Lower), Vector256.LessThanOrEqual(a.Upper, b.Upper));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket operator >=(FloatPacket a, FloatPacket b) =>
        new(Vector256.GreaterThanOrEqual(a.Lower, b.Lower), Vector256.GreaterThanOrEqual(a.Upper, b.Upper));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket operator &(FloatPacket a, FloatPacket b) => new(a.Lower & b.Lower, a.Upper & b.Upper);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket operator |(FloatPacket a, FloatPacket b) => new(a.Lower | b.Lower, a.Upper | b.Upper);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket Sqrt(FloatPacket x) => new(Vector256.Sqrt(x.Lower), Vector256.Sqrt(x.Upper));

    /// <summary>There is no NaN where <see cref="ErrorBound"/> is finite.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket Min(FloatPacket a, FloatPacket b) =>
        new(Vector256.MinNative(a.Lower, b.Lower), Vector256.MinNative(a.Upper, b.Upper));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket Max(FloatPacket a, FloatPacket b) =>
        new(Vector256.MaxNative(a.Lower, b.Lower), Vector256.MaxNative(a.Upper, b.Upper));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket Select(FloatPacket mask, FloatPacket a, FloatPacket b) =>
        new(Vector256.ConditionalSelect(mask.Lower, a.Lower, b.Lower), Vector256.ConditionalSelect(mask.Upper, a.Upper, b.Upper));

    [MethodImpl(MethodImplOptions.AggressiveInlining)] // in a large method, the interface's default would not be inlined
    public static FloatPacket If(FloatPacket mask, FloatPacket value) => Select(mask, value, double.NaN);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket Of(Vector256<float> row) => new(row, row);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket Row(float[] numbers, int first) => Of(numbers.Load256(first));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket PerRow(float[] numbers, int first) =>
        new(Vector256.Create(numbers[first]), Vector256.Create(numbers[first + 1]));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket Rows(float[] lower, float[] upper, int first) => new(lower.Load256(first), upper.Load256(first));

    /// <summary>One division and three products, each of which rounds.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3<FloatPacket> Divide(Vector3<FloatPacket> a, FloatPacket b) => (FloatPacket)1 / b * a;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket Pixels(FloatPacket r, FloatPacket g, FloatPacket b) =>
        new(FloatBytes.Packed(r.Lower, g.Lower, b.Lower).AsSingle(), FloatBytes.Packed(r.Upper, g.Upper, b.Upper).AsSingle());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public uint WriteRange(FloatPacket ends, int background, byte[] rgb, int place, int count)
    {
        var (isMiss, most, least) = (Vector256.Equals(ends.Lower, Vector256<float>.Zero).AsInt32(), Lower.AsInt32(), Upper.AsInt32());
        var pixels = Vector256.ConditionalSelect(isMiss, Vector256.Create(background), least);
        if (count >= Count) FloatBytes.Store(pixels, rgb, place);
        else FloatBytes.StoreFew(pixels, rgb.AsSpan(place, 3 * count));
        return (uint)(Vector256.Equals(least, most) | isMiss).ExtractMostSignificantBits() ^ 0xFF;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public uint Write(in FloatLevels levels, byte[] rgb, int lower, int upper)
    {
        var ofUpper = Write(Upper, levels, rgb, upper);
        return Write(Lower, levels, rgb, lower) | (ofUpper << Count);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static uint Write(Vector256<float> t, in FloatLevels levels, byte[] rgb, int place)
    {
        var least = FloatBytes.Packed(levels.Red.Least(t), levels.Green.Least(t), levels.Blue.Least(t));
        var most = FloatBytes.Packed(levels.Red.Most(t), levels.Green.Most(t), levels.Blue.Most(t));
        FloatBytes.Store(least, rgb, place);
        return (uint)Vector256.Equals(least, most).ExtractMostSignificantBits() ^ 0xFF;
    }
}
