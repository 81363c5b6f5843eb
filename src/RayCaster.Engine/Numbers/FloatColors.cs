namespace RayCaster.Engine;

/// <summary>The colours of a scene as integers, in small steps; the lanes of a packet look them up at once.</summary>
internal sealed class FloatColors
{
    private const int ChannelBits = 21;

    /// <summary>The most steps of a channel.</summary>
    public const int MaxSteps = (1 << ChannelBits) - 1;

    private readonly long[] packed; // three channels in each

    /// <param name="light">Red, green and blue of the background, then of the models.</param>
    /// <param name="most">The greatest of them.</param>
    public FloatColors(double[] light, double most, int threads = 1)
    {
        var count = light.Length / 3;
        Step = Math.Max(most, double.Epsilon * MaxSteps) / MaxSteps;
        packed = new long[count];
        ThreadTeam.Shares(ThreadTeam.SharesOf(count, threads), count, (_, first, end) =>
        {
            for (var i = first; i < end; i++)
            {
                var (r, g, b) = (Steps(light[3 * i]), Steps(light[3 * i + 1]), Steps(light[3 * i + 2]));
                packed[i] = r | (g << ChannelBits) | (b << (2 * ChannelBits));
            }
        });

        long Steps(double channel) => Math.Min((long)(channel / Step + 0.5), MaxSteps);
    }

    /// <summary>The light of one step.</summary>
    public double Step { get; }

    public RawSpan<long> Packed => new(packed);

    /// <summary>The channels of several pixels, in steps.</summary>
    /// <param name="packed">The <see cref="Packed"/> colours.</param>
    /// <param name="colorIndices">The index of each pixel's colour.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static (FloatPacket R, FloatPacket G, FloatPacket B) At(RawSpan<long> packed, Vector256<int> colorIndices)
    {
        var (first, second) = (Gather(packed, colorIndices.GetLower()), Gather(packed, colorIndices.GetUpper()));
        var (low, high) = (Vector256.Narrow(first, second), Vector256.Narrow(first >>> 32, second >>> 32));
        var mask = Vector256.Create(MaxSteps);
        return (
            new(Vector256.ConvertToSingle(low & mask)),
            new(Vector256.ConvertToSingle(((low >>> ChannelBits) | (high << (32 - ChannelBits))) & mask)),
            new(Vector256.ConvertToSingle(high >>> (2 * ChannelBits - 32))));
    }

    /// <summary>The colours with these indices. (The gather instruction takes twice as long.)</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<long> Gather(RawSpan<long> packed, Vector128<int> colorIndices) =>
        Vector256.Create(packed[colorIndices[0]], packed[colorIndices[1]], packed[colorIndices[2]], packed[colorIndices[3]]);
}
