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

    /// <summary>Loads and rounds.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket Load(double[] numbers, int first) =>
        new(Vector256.Narrow(Packet.Load(numbers, first).Lanes, Packet.Load(numbers, first + Packet.Count).Lanes));

    /// <summary>Indices + 1 as ints, stored in the float lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket LoadColorIndices(double[] indices, int first)
    {
        var (lower, upper) = (Packet.Load(indices, first).ToInts(), Packet.Load(indices, first + Packet.Count).ToInts());
        return new((Vector256.Create(lower, upper) + Vector256<int>.One).AsSingle());
    }

    /// <summary>The colours with these indices, in steps.</summary>
    /// <param name="colors"><see cref="FloatColors.Packed"/>.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static (FloatPacket R, FloatPacket G, FloatPacket B) ColorsAt(RawSpan<long> colors, FloatPacket colorIndices)
    {
        var (r, g, b) = FloatColors.At(colors, colorIndices.Lanes.AsInt32());
        return (new(r), new(g), new(b));
    }

    /// <summary>One division and three products, each of which rounds.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3<FloatPacket> Divide(Vector3<FloatPacket> a, FloatPacket b) => (FloatPacket)1 / b * a;

    /// <summary>The whole parts of three channels' levels: three bytes for each pixel, stored in its float lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket Pixels(FloatPacket r, FloatPacket g, FloatPacket b) => new(FloatBytes.Packed(r.Lanes, g.Lanes, b.Lanes).AsSingle());

    /// <summary>Writes the bytes of some pixels of <see cref="Pixels"/> with the least levels, and says which differ from those with the
    /// greatest.</summary>
    /// <param name="candidateDepth">0 for pixels without a hit, as a float or as an int.</param>
    /// <returns>A bit for each uncertain pixel.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint WriteRange(FloatPacket least, FloatPacket most, FloatPacket candidateDepth, int background, byte[] rgb, int offset)
    {
        var (isMiss, pixels) = (Vector256.Equals(candidateDepth.Lanes, Vector256<float>.Zero).AsInt32(), least.Lanes.AsInt32());
        FloatBytes.Store(Vector256.ConditionalSelect(isMiss, Vector256.Create(background), pixels), rgb, offset);
        return (uint)(Vector256.Equals(pixels, most.Lanes.AsInt32()) | isMiss).ExtractMostSignificantBits() ^ 0xFF;
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
