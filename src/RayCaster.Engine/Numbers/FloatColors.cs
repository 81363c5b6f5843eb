namespace RayCaster.Engine;

/// <summary>The colours of a scene as integers, in small steps; the lanes of a packet look them up at once.</summary>
internal sealed partial class FloatColors
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

    /// <summary>The colours at some colorIndices. (The processor's own instruction for it takes twice as long.)</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<long> Gather(RawSpan<long> packed, Vector128<int> colorIndices) =>
        Vector256.Create(packed[colorIndices[0]], packed[colorIndices[1]], packed[colorIndices[2]], packed[colorIndices[3]]);

    /// <inheritdoc cref="Gather(RawSpan{long}, Vector128{int})"/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<long> Gather(RawSpan<long> packed, Vector256<int> colorIndices) =>
        Vector512.Create(Gather(packed, colorIndices.GetLower()), Gather(packed, colorIndices.GetUpper()));
}
