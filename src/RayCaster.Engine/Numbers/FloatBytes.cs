using System.Runtime.Intrinsics.X86;

namespace RayCaster.Engine;

/// <summary>Converts channels' levels from floats to bytes. A byte is certain where both ends of a level's range have the same whole part.</summary>
internal static class FloatBytes
{
    /// <summary>The rounding error of a range's ends: levels are below 256, so half a float's unit is 2⁻¹⁷.</summary>
    public const double RoundingOfTheEnds = 7.7e-6;

    /// <summary>The same for a level that is computed from t, a slope and the level at 0: rounding the latter and the sum adds 2⁻¹⁷ each, rounding
    /// the slope 2⁻²⁴ of less than 256, which is 2⁻¹⁶.</summary>
    public const double RoundingOfALine = 3.9e-5;

    /// <summary>Whether this machine computes with <see cref="FloatPacket"/>.</summary>
    public static bool IsSupported => Avx2.IsSupported && Fma.IsSupported;

    /// <summary>The whole parts of three channels, packed into one int.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<int> Packed(Vector256<float> r, Vector256<float> g, Vector256<float> b) =>
        Vector256.ConvertToInt32Native(r) | (Vector256.ConvertToInt32Native(g) << 8) | (Vector256.ConvertToInt32Native(b) << 16);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Store(Vector256<int> pixels, byte[] rgb, int offset)
    {
        var bytes = InARow(pixels);
        bytes.GetLower().StoreTo(rgb, offset);
        bytes.GetUpper().StoreTo(rgb, offset + Vector256<byte>.Count / 4);
    }

    /// <summary>Three bytes of each of 8 pixels, without the fourth: the first 16 of the 24, then the last 16.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<byte> InARow(Vector256<int> pixels)
    {
        var within = Vector256.Create((byte)
            0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14, 255, 255, 255, 255,
            0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14, 255, 255, 255, 255);
        return Avx2.PermuteVar8x32(Avx2.Shuffle(pixels.AsByte(), within).AsInt32(), Vector256.Create(0, 1, 2, 4, 2, 4, 5, 6)).AsByte();
    }
}
