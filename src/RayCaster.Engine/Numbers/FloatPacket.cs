namespace RayCaster.Engine;

/// <summary>
/// Floats of eight pixels side by side; as a mask all bits of a lane set for true, none for false. A formula over it is much faster than over
/// doubles, and <see cref="ErrorBound"/> bounds its error.
/// </summary>
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
internal readonly struct FloatPacket(Vector256<float> lanes) : IReal<FloatPacket>
{
    public readonly Vector256<float> Lanes = lanes;

    public static int Count => Vector256<float>.Count;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator FloatPacket(double value) => new(Vector256.Create((float)value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket operator +(FloatPacket a, FloatPacket b) => new(a.Lanes + b.Lanes);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket operator -(FloatPacket a, FloatPacket b) => new(a.Lanes - b.Lanes);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket operator -(FloatPacket a) => new(-a.Lanes);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket operator *(FloatPacket a, FloatPacket b) => new(a.Lanes * b.Lanes);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket operator /(FloatPacket a, FloatPacket b) => new(a.Lanes / b.Lanes);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket operator <(FloatPacket a, FloatPacket b) => new(Vector256.LessThan(a.Lanes, b.Lanes));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket operator >(FloatPacket a, FloatPacket b) => new(Vector256.GreaterThan(a.Lanes, b.Lanes));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket operator <=(FloatPacket a, FloatPacket b) => new(Vector256.LessThanOrEqual(a.Lanes, b.Lanes));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket operator >=(FloatPacket a, FloatPacket b) => new(Vector256.GreaterThanOrEqual(a.Lanes, b.Lanes));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket operator &(FloatPacket a, FloatPacket b) => new(a.Lanes & b.Lanes);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket operator |(FloatPacket a, FloatPacket b) => new(a.Lanes | b.Lanes);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket Sqrt(FloatPacket x) => new(Vector256.Sqrt(x.Lanes));

    /// <summary>There is no NaN where <see cref="ErrorBound"/> is finite.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket Min(FloatPacket a, FloatPacket b) => new(Vector256.MinNative(a.Lanes, b.Lanes));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket Max(FloatPacket a, FloatPacket b) => new(Vector256.MaxNative(a.Lanes, b.Lanes));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket Select(FloatPacket mask, FloatPacket a, FloatPacket b) =>
        new(Vector256.ConditionalSelect(mask.Lanes, a.Lanes, b.Lanes));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket Load(float[] numbers, int first) => new(numbers.Load256(first));

    /// <summary>One division and three products, each of which rounds.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3<FloatPacket> Divide(Vector3<FloatPacket> a, FloatPacket b) => (FloatPacket)1 / b * a;

    /// <summary>The whole parts of three channels' levels: three bytes for each pixel.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<int> Pixels(FloatPacket r, FloatPacket g, FloatPacket b) => FloatBytes.Packed(r.Lanes, g.Lanes, b.Lanes);

    /// <summary>Writes the bytes of pixels with the least levels, and says which differ from those with the greatest.</summary>
    /// <param name="misses">The mask of pixels without a hit, which show the background.</param>
    /// <returns>A bit for each uncertain pixel.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint WriteRange(Vector256<int> least, Vector256<int> most, Vector256<int> misses, int background, byte[] rgb, int offset)
    {
        FloatBytes.Store(Vector256.ConditionalSelect(misses, Vector256.Create(background), least), rgb, offset);
        return (uint)(Vector256.Equals(least, most) | misses).ExtractMostSignificantBits() ^ 0xFF;
    }

    /// <summary>Writes the bytes of hits.</summary>
    /// <returns>A bit for each pixel with an uncertain byte.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public uint Write(in FloatLevels levels, byte[] rgb, int offset)
    {
        var (red, green, blue) = (levels.Red.Least(Lanes), levels.Green.Least(Lanes), levels.Blue.Least(Lanes));
        var least = FloatBytes.Packed(red, green, blue);
        var most = FloatBytes.Packed(levels.Red.Most(red), levels.Green.Most(green), levels.Blue.Most(blue));
        FloatBytes.Store(least, rgb, offset);
        return (uint)Vector256.Equals(least, most).ExtractMostSignificantBits() ^ 0xFF;
    }
}
