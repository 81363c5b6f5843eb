namespace RayCaster.Engine;

// The build makes overloads for vectors of twice the length of this file (RayCaster.Engine.csproj).

internal static partial class FloatBytes
{
    /// <summary>The whole parts of three channels, packed into one int.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<int> Packed(Vector256<float> r, Vector256<float> g, Vector256<float> b) =>
        Vector256.ConvertToInt32Native(r) | (Vector256.ConvertToInt32Native(g) << 8) | (Vector256.ConvertToInt32Native(b) << 16);

    /// <summary>Writes three bytes of each pixel.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Store(Vector256<int> pixels, byte[] rgb, int offset)
    {
        var bytes = InARow(pixels);
        bytes.GetLower().StoreTo(rgb, offset);
        bytes.GetUpper().GetLower().StoreTo(rgb, offset + Vector256<byte>.Count / 2);
    }
}

internal readonly partial struct FloatLevel
{
    /// <summary>The level is certainly not less than this.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector256<float> Least(Vector256<float> t) => Vector256.FusedMultiplyAdd(t, Vector256.Create(slope), Vector256.Create(least));

    /// <summary>The level is certainly not more than this.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector256<float> Most(Vector256<float> least) => least + Vector256.Create(width);
}

internal sealed partial class FloatColors
{
    /// <summary>The channels of several pixels, in steps.</summary>
    /// <param name="packed">The <see cref="Packed"/> colours.</param>
    /// <param name="colorIndices">The index of each pixel's colour.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static (Vector256<float> R, Vector256<float> G, Vector256<float> B) At(RawSpan<long> packed, Vector256<int> colorIndices)
    {
        var (first, second) = (Gather(packed, colorIndices.GetLower()), Gather(packed, colorIndices.GetUpper()));
        var (low, high) = (Vector256.Narrow(first, second), Vector256.Narrow(first >>> 32, second >>> 32));
        var mask = Vector256.Create(MaxSteps);
        return (
            Vector256.ConvertToSingle(low & mask),
            Vector256.ConvertToSingle(((low >>> ChannelBits) | (high << (32 - ChannelBits))) & mask),
            Vector256.ConvertToSingle(high >>> (2 * ChannelBits - 32)));
    }
}
