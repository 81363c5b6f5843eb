namespace RayCaster.Engine;

/// <summary>
/// What the filter stores for each pixel of a tile: the triangle that may be in front. A triangle that certainly covers a pixel hides what is
/// certainly behind it. Where two are too close to each other, or a sample is too close to an edge, the second triangle is queued, and its formula
/// decides.
/// </summary>
internal sealed class TilePixels
{
    /// <summary>The distance from a pixel to the one above it. A packet at the end of a row leaves the next row unchanged.</summary>
    public const int Stride = Tile.MaxSide;

    /// <summary>The number of pixels, with room for a packet that begins at the last one, and for three rows above, since at least four rows are
    /// processed.</summary>
    public const int Size = Stride * (Tile.MaxSide + 4) + 8;

    private const int QueueLength = 1 << 14;

    private readonly Duplicates duplicates = new([], []);

    /// <summary>Each pixel certainly has a hit with at least this inverse depth; 0 for none.</summary>
    public float[] OccluderInverseDepth { get; } = new float[Size];

    /// <summary>The greatest inverse depth of the proposed triangle; 0 if there is none.</summary>
    public float[] CandidateInverseDepth { get; } = new float[Size];

    /// <summary>The proposed triangle; any number if there is none.</summary>
    public int[] Proposed { get; } = new int[Size];

    /// <summary>The least t of the hits that the formula computed; +∞ if there are none. Valid only if <see cref="HasExactT"/>.</summary>
    public double[] ExactT { get; } = new double[Size];

    public bool HasExactT { get; private set; }

    public PooledList<(int Pixel, int Triangle, float MaxInverseDepth)> Queue { get; } = new();

    /// <summary>Whether the queue is so long that the formula should decide now.</summary>
    public bool IsFull => Queue.Count > QueueLength;

    public PixelRect Rect { get; private set; }

    public void SetMesh(Vector3[] vertices, int[] indices) => duplicates.SetMesh(vertices, indices);

    /// <summary>Forgets all. Places outside the tile are covered, so that they do not affect the coarse depth.</summary>
    public void Begin(in PixelRect tile)
    {
        Rect = tile;
        HasExactT = false;
        duplicates.Clear();
        OccluderInverseDepth.AsSpan().Clear();
        CandidateInverseDepth.AsSpan().Clear();
        Proposed.AsSpan().Clear();
        for (var row = 0; row < Tile.MaxSide; row++)
            OccluderInverseDepth.AsSpan(row * Stride, Stride)[(row < tile.Height ? tile.Width : 0)..].Fill(float.PositiveInfinity);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    public void Enqueue(int pixel, int triangle, float maxInverseDepth)
    {
        if (!duplicates.HasEarlier(triangle)) Queue.Add((pixel, triangle, maxInverseDepth));
    }

    /// <summary>Queues some pixels of a triangle.</summary>
    /// <param name="pixels">The first pixel of each packet.</param>
    /// <param name="lanes">A bit for each pixel of a packet that is queued.</param>
    /// <param name="maxInverseDepth">The greatest inverse depth of each pixel.</param>
    public void Enqueue(int triangle, int count, int[] pixels, uint[] lanes, float[] maxInverseDepth)
    {
        if (duplicates.HasEarlier(triangle)) return;
        for (var k = 0; k < count; k++)
        {
            for (var left = lanes[k]; left != 0; left &= left - 1)
            {
                var i = BitOperations.TrailingZeroCount(left);
                Queue.Add((pixels[k] + i, triangle, maxInverseDepth[8 * k + i]));
            }
        }
    }

    public void BeginExactT()
    {
        if (!HasExactT) ExactT.AsSpan().Fill(double.PositiveInfinity);
        HasExactT = true;
    }
}
