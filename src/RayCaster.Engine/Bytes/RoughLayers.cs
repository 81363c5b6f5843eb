using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace RayCaster.Engine;

/// <summary>Where several shapes all cover a small part: of each pixel what the nearest of them shows, so far.</summary>
/// <param name="doubts">Takes a bit for each pixel of each packet.</param>
internal sealed class RoughLayers(ushort[] doubts)
{
    private readonly float[] nearest = new float[RaySpan.MaxArea];
    private readonly int[] pixels = new int[RaySpan.MaxArea];
    private double error; // no t so far is farther from its double than this

    /// <summary>Forgets all shapes.</summary>
    public void Clear()
    {
        Array.Fill(nearest, float.PositiveInfinity);
        error = 0;
    }

    /// <summary>Comes to another shape.</summary>
    /// <param name="error">How far its t may be from those in doubles.</param>
    /// <param name="packets">How many packets there are in a row.</param>
    public Layer Add(double error, int packets)
    {
        // Of two t that differ by more than both errors the lesser one is less in doubles, too. The difference itself is rounded by 2⁻²⁴ of it.
        var both = (this.error + error) * 1.000001;
        this.error = Math.Max(this.error, error);
        return new(nearest, pixels, doubts, (float)both, packets);
    }

    /// <summary>Writes the pixels.</summary>
    /// <param name="part">The part.</param>
    /// <param name="rgb">Room for the bytes.</param>
    /// <param name="first">The place of the lowest row's first pixel.</param>
    /// <param name="step">From a pixel's place to that of the one above it.</param>
    public void Write(in Tile part, byte[] rgb, int first, int step)
    {
        var i = 0;
        for (var row = 0; row < part.Height; row++, first += step)
            for (var at = 0; at < part.Width; at += RoughPacket.Count, i += RoughPacket.Count)
                RoughBytes.Store(pixels.Load512(i), rgb, first + 3 * at);
    }

    /// <summary>Puts a shape into the picture where it is nearer than those before.</summary>
    [method: MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly struct Layer(float[] nearest, int[] pixels, ushort[] doubts, float slack, int packets) : IRoughTarget
    {
        /// <inheritdoc/>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Take(int row, int packet, Vector512<float> t, Vector512<int> least, Vector512<int> most)
        {
            var place = row * packets + packet;
            var at = place * RoughPacket.Count;
            var old = nearest.Load512(at);
            var difference = t - old; // −∞ for the first shape
            var isNearer = Vector512.LessThan(difference, Vector512<float>.Zero).AsInt32();
            var isDecided = Vector512.GreaterThan(Vector512.Abs(difference), Vector512.Create(slack));
            var nearer = (uint)isNearer.ExtractMostSignificantBits();
            var doubtful = (uint)~Vector512.Equals(least, most).ExtractMostSignificantBits();
            doubts[place] = (ushort)((doubtful & nearer) | (doubts[place] & ~nearer) | ~(uint)isDecided.ExtractMostSignificantBits());
            Vector512.Min(t, old).StoreTo(nearest, at);
            Vector512.ConditionalSelect(isNearer, least, pixels.Load512(at)).StoreTo(pixels, at);
        }
    }
}
