using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace RayCaster.Engine;

/// <summary>Where one shape alone shows: what it shows are the pixels.</summary>
/// <param name="rgb">Room for the bytes.</param>
/// <param name="first">The place of the lowest row's first pixel.</param>
/// <param name="step">From a pixel's place to that of the one above it.</param>
/// <param name="doubts">Takes a bit for each pixel of each packet.</param>
/// <param name="packets">How many packets there are in a row.</param>
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
internal readonly struct RoughPixels(byte[] rgb, int first, int step, ushort[] doubts, int packets) : IRoughTarget
{
    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Take(int row, int packet, Vector512<float> t, Vector512<int> least, Vector512<int> most)
    {
        doubts[row * packets + packet] = (ushort)~Vector512.Equals(least, most).ExtractMostSignificantBits();
        RoughBytes.Store(least, rgb, first + row * step + packet * 3 * RoughPacket.Count);
    }
}
