using System.Runtime.Intrinsics.X86;

namespace RayCaster.Engine;

/// <summary>The colours of a scene as integers, in small steps; sixteen lanes look them up at once.</summary>
internal sealed class FloatColors
{
    private const int ChannelBits = 21;

    /// <summary>The most steps of a channel.</summary>
    public const int MostSteps = (1 << ChannelBits) - 1;

    private readonly long[] packed; // three channels in each

    /// <param name="light">Red, green and blue of the background, then of the models.</param>
    /// <param name="most">The greatest of them.</param>
    public FloatColors(double[] light, double most, int threads = 1)
    {
        var count = light.Length / 3;
        Step = Math.Max(most, double.Epsilon * MostSteps) / MostSteps;
        packed = new long[count];
        ThreadTeam.Shares(ThreadTeam.SharesOf(count, threads), count, (_, first, end) =>
        {
            for (var i = first; i < end; i++)
            {
                var (r, g, b) = (Steps(light[3 * i]), Steps(light[3 * i + 1]), Steps(light[3 * i + 2]));
                packed[i] = r | (g << ChannelBits) | (b << (2 * ChannelBits));
            }
        });

        long Steps(double channel) => Math.Min((long)(channel / Step + 0.5), MostSteps);
    }

    /// <summary>The light of one step.</summary>
    public double Step { get; }

    public RawSpan<long> Packed => new(packed);

    /// <summary>The channels of sixteen pixels, in steps.</summary>
    /// <param name="packed">The <see cref="Packed"/> colours.</param>
    /// <param name="places">The place of each pixel's colour.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static (Vector512<float> R, Vector512<float> G, Vector512<float> B) At(RawSpan<long> packed, Vector512<int> places)
    {
        var (first, second) = (Gather(packed, places.GetLower()), Gather(packed, places.GetUpper()));
        var low = Avx512F.PermuteVar16x32x2(first, Vector512.CreateSequence(0, 2), second);
        var high = Avx512F.PermuteVar16x32x2(first, Vector512.CreateSequence(1, 2), second);
        var mask = Vector512.Create(MostSteps);
        return (
            Avx512F.ConvertToVector512Single(low & mask),
            Avx512F.ConvertToVector512Single(((low >>> ChannelBits) | (high << (32 - ChannelBits))) & mask),
            Avx512F.ConvertToVector512Single(high >>> (2 * ChannelBits - 32)));
    }

    /// <summary>Eight colours. (The processor's own instruction for it takes twice as long.)</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<int> Gather(RawSpan<long> packed, Vector256<int> places) => Vector512.Create(
        packed[places[0]], packed[places[1]], packed[places[2]], packed[places[3]],
        packed[places[4]], packed[places[5]], packed[places[6]], packed[places[7]]).AsInt32();
}
