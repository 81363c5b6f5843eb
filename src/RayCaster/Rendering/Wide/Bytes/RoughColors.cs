using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace RayCaster;

/// <summary>The colours of a scene as whole numbers of small steps, which sixteen lanes look up at once.</summary>
internal sealed class RoughColors
{
    /// <summary>Up to so many colours lie in vectors, from which lanes take them without a look at memory; more are packed, three channels to a long.</summary>
    private const int Few = 32;

    private const int ChannelBits = 21;
    private const int ChannelMask = (1 << ChannelBits) - 1;

    private readonly float[] reds = new float[Few], greens = new float[Few], blues = new float[Few];
    private readonly long[] packed = [];

    /// <param name="scene">The scene, whose background comes first, and then its models.</param>
    public RoughColors(Scene scene)
    {
        var most = Most(scene.Background);
        var models = scene.Models;
        for (var i = 0; i < models.Count; i++) most = Math.Max(most, Most(models[i].Color));
        MostSteps = models.Count < Few ? 1 << 24 : ChannelMask; // floats are exact up to 2²⁴
        Step = Math.Max(most, double.Epsilon * MostSteps) / MostSteps;
        if (models.Count >= Few) packed = new long[models.Count + 1];
        Set(0, scene.Background);
        for (var i = 0; i < models.Count; i++) Set(i + 1, models[i].Color);

        static double Most(Color color) => Math.Max(color.R, Math.Max(color.G, color.B));
    }

    /// <summary>How much light one step is.</summary>
    public double Step { get; }

    /// <summary>No channel has more steps.</summary>
    public int MostSteps { get; }

    /// <summary>Colours that do not lie in vectors; empty where all do.</summary>
    public ReadOnlySpan<long> Packed => packed;

    /// <summary>The channels of sixteen pixels, in steps.</summary>
    /// <param name="packed">The first of <see cref="Packed"/>, or null.</param>
    /// <param name="places">The places of the pixels' colours.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public unsafe (Vector512<float> R, Vector512<float> G, Vector512<float> B) At(long* packed, Vector512<int> places)
    {
        if (packed is null) return (FromFew(reds, places), FromFew(greens, places), FromFew(blues, places));
        var (first, second) = (Gather(packed, places.GetLower()), Gather(packed, places.GetUpper()));
        var low = Avx512F.PermuteVar16x32x2(first, Vector512.CreateSequence(0, 2), second);
        var high = Avx512F.PermuteVar16x32x2(first, Vector512.CreateSequence(1, 2), second);
        var mask = Vector512.Create(ChannelMask);
        return (
            Avx512F.ConvertToVector512Single(low & mask),
            Avx512F.ConvertToVector512Single(((low >>> ChannelBits) | (high << (32 - ChannelBits))) & mask),
            Avx512F.ConvertToVector512Single(high >>> (2 * ChannelBits - 32)));
    }

    private void Set(int place, Color color)
    {
        var (r, g, b) = (Steps(color.R), Steps(color.G), Steps(color.B));
        if (packed.Length > 0) packed[place] = r | (g << ChannelBits) | (b << (2 * ChannelBits));
        else (reds[place], greens[place], blues[place]) = (r, g, b);

        long Steps(double channel) => Math.Min((long)(channel / Step + 0.5), MostSteps);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static unsafe Vector512<int> Gather(long* packed, Vector256<int> places) => Vector512.Create(
        Avx2.GatherVector256(packed, places.GetLower(), sizeof(long)), Avx2.GatherVector256(packed, places.GetUpper(), sizeof(long))).AsInt32();

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<float> FromFew(float[] table, Vector512<int> places) =>
        Avx512F.PermuteVar16x32x2(Vector512.LoadUnsafe(ref table[0]), places, Vector512.LoadUnsafe(ref table[16]));
}
