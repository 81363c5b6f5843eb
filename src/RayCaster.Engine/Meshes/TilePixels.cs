using System.Numerics;
using System.Runtime.CompilerServices;

namespace RayCaster.Engine;

/// <summary>
/// What one thread knows of each pixel of a tile: the triangle that may be in front there. A triangle that surely covers a pixel hides all that is
/// surely behind it; where two are too close to each other or a sample too close to a side, the second one waits in a queue for its formula.
/// </summary>
internal sealed class TilePixels
{
    /// <summary>From a pixel to the one above it. What a packet at the end of a row holds of the next one stays as it is.</summary>
    public const int Stride = Tile.MaxSide;

    /// <summary>How many pixels there are, with room for a packet that begins at the last, and for three rows above, since at least four rows are
    /// looked at.</summary>
    public const int Size = Stride * (Tile.MaxSide + 4) + 8;

    private const int QueueLength = 1 << 14;

    private readonly Duplicates twins = new([], []);

    /// <summary>A hit with at least this w is sure; 0 for none.</summary>
    public float[] Covered { get; } = new float[Size];

    /// <summary>The w of the proposed triangle is at most this; 0 where there is none.</summary>
    public float[] Front { get; } = new float[Size];

    /// <summary>The triangle; any where there is none.</summary>
    public int[] Proposed { get; } = new int[Size];

    /// <summary>The least t of the hits that the formula had to decide; +∞ where there are none. It means nothing unless
    /// <see cref="HasDecided"/>.</summary>
    public double[] Decided { get; } = new double[Size];

    /// <summary>Whether the formula had to decide about any pixel.</summary>
    public bool HasDecided { get; private set; }

    /// <summary>Pixels and triangles that wait for the formula.</summary>
    public PooledList<(int Pixel, int Triangle, float MostW)> Queue { get; } = new();

    /// <summary>Whether so many wait that the formula should decide about them now.</summary>
    public bool IsFull => Queue.Count > QueueLength;

    public Tile Tile { get; private set; }

    public void Show(Vector3[] vertices, int[] indices) => twins.Show(vertices, indices);

    /// <summary>Forgets all; beyond the tile's pixels everything is covered, so that they do not count where the least is looked for.</summary>
    public void Enter(in Tile tile)
    {
        Tile = tile;
        HasDecided = false;
        twins.Clear();
        Covered.AsSpan().Clear();
        Front.AsSpan().Clear();
        Proposed.AsSpan().Clear();
        for (var row = 0; row < Tile.MaxSide; row++)
            Covered.AsSpan(row * Stride, Stride)[(row < tile.Height ? tile.Width : 0)..].Fill(float.PositiveInfinity);
    }

    /// <summary>Lets a pixel's triangle wait for its formula.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public void Enqueue(int pixel, int triangle, float mostW)
    {
        if (!twins.HasEarlier(triangle)) Queue.Add((pixel, triangle, mostW));
    }

    /// <summary>The same for some pixels.</summary>
    /// <param name="count">How many packets of pixels there are.</param>
    /// <param name="pixels">Their first pixels.</param>
    /// <param name="lanes">A bit for each of their pixels that is meant.</param>
    /// <param name="mostW">The w of all of their pixels.</param>
    public void Enqueue(int triangle, int count, int[] pixels, uint[] lanes, float[] mostW)
    {
        if (twins.HasEarlier(triangle)) return;
        for (var k = 0; k < count; k++)
        {
            for (var left = lanes[k]; left != 0; left &= left - 1)
            {
                var i = BitOperations.TrailingZeroCount(left);
                Queue.Add((pixels[k] + i, triangle, mostW[8 * k + i]));
            }
        }
    }

    /// <summary>Says that the formula decides about some pixels.</summary>
    public void BeginDecided()
    {
        if (!HasDecided) Decided.AsSpan().Fill(double.PositiveInfinity);
        HasDecided = true;
    }
}
