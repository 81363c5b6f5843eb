using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace RayCaster.Engine;

/// <summary>
/// What one thread knows of each pixel of a tile: the triangle that may be in front there. A triangle that surely covers a pixel hides all that is surely
/// behind it; where two are too close to each other or a sample too close to a side, the second one waits in a queue for its formula.
/// </summary>
internal sealed class TilePixels(ScreenSpace screen)
{
    /// <summary>From a pixel to the one above it. What a packet at the end of a row holds of the next one stays as it is.</summary>
    public const int Stride = Tile.MaxSide;

    /// <summary>How many pixels there are, with room for a packet that begins at the last, and for a row above, since rows are looked at by twos.</summary>
    public const int Size = Stride * (Tile.MaxSide + 1) + 8;

    private const int QueueLength = 1 << 14;

    private readonly ExactHits exact = new(screen);
    private readonly Columns columns = new(screen.Camera, Tile.MaxSide);
    private readonly double[] decided = new double[Size]; // the least t of the hits that had to be decided by the formula
    private readonly GrowingArray<(int Pixel, int Triangle, float MostW)> queue = new();
    private readonly Twins twins = new([], []);
    private Tile tile;
    private bool hasDecided;

    /// <summary>A hit with at least this w is sure; 0 for none.</summary>
    public float[] Covered { get; } = new float[Size];

    /// <summary>The w of the proposed triangle is at most this; 0 where there is none.</summary>
    public float[] Front { get; } = new float[Size];

    /// <summary>The triangle; any where there is none.</summary>
    public int[] Proposed { get; } = new int[Size];

    /// <summary>Comes to another mesh.</summary>
    public void Show(Vector3[] vertices, int[] indices)
    {
        exact.Show(vertices, indices);
        twins.Show(vertices, indices);
    }

    /// <summary>Forgets all; beyond the tile's pixels everything is covered, so that they do not count where the least is looked for.</summary>
    public void Enter(in Tile tile)
    {
        this.tile = tile;
        hasDecided = false;
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
        if (!twins.HasEarlier(triangle)) queue.Add((pixel, triangle, mostW));
    }

    /// <summary>The same for some pixels.</summary>
    /// <param name="triangle">The triangle.</param>
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
                queue.Add((pixels[k] + i, triangle, mostW[8 * k + i]));
            }
        }
    }

    /// <summary>Asks the formula if many triangles wait.</summary>
    public void DecideIfMany()
    {
        if (queue.Count > QueueLength) Decide();
    }

    /// <summary>Asks the formula about what waits and may still be in front.</summary>
    public void Decide()
    {
        if (queue.Count == 0) return;
        if (!hasDecided) decided.AsSpan().Fill(double.PositiveInfinity);
        hasDecided = true;
        foreach (var (pixel, triangle, mostW) in queue.Items)
        {
            if (mostW < Covered[pixel]) continue;
            exact.Add(tile.Column + pixel % Stride, tile.Row + pixel / Stride, triangle, pixel, decided, Covered);
        }
        exact.Flush(decided, Covered);
        queue.Clear();
    }

    /// <summary>Keeps the hits of a part of a row of the tile.</summary>
    public void Meet(RaySpan span, int index)
    {
        if (Vector512.IsHardwareAccelerated) Meet<WidePacket>(span, index);
        else Meet<Packet>(span, index);
    }

    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private void Meet<N>(RaySpan span, int index) where N : struct, IPacket<N>
    {
        var first = (span.Row - tile.Row) * Stride + span.Column - tile.Column;
        for (var i = 0; i < span.Length; i += N.Count)
        {
            var at = first + i;
            var hit = Lanes.Broadcast<N>(double.NaN);
            if (HasAny<N>(at)) hit = span.First(i, exact.Cross(span.RaysAt<N>(i), ref Proposed[at]));
            if (hasDecided)
            {
                var other = N.Load(decided, at);
                hit = N.Select(hit <= other, hit, other);
            }
            span.Keep(i, hit, Lanes.Broadcast<N>(index));
        }
    }

    /// <summary>Writes down the hits of the tile, which has the width of a packet at least, and in which nothing but the mesh may show.</summary>
    /// <param name="index">The place of the mesh in the scene.</param>
    /// <param name="t">Room for the ray parameters; +∞ for no hit.</param>
    /// <param name="models">Room for the models; −1 for no hit.</param>
    /// <param name="first">The place of the lowest row's first pixel; the others of the row follow.</param>
    /// <param name="step">From a pixel's place to that of the one above it.</param>
    public void Hit(int index, double[] t, int[] models, int first, int step)
    {
        if (Vector512.IsHardwareAccelerated) Hit<WidePacket>(index, t, models, first, step);
        else Hit<Packet>(index, t, models, first, step);
    }

    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private void Hit<N>(int index, double[] t, int[] models, int first, int step) where N : struct, IPacket<N>
    {
        var (camera, miss) = (screen.Camera, Lanes.Broadcast<N>(double.PositiveInfinity));
        var (some, none) = (Lanes.Broadcast<N>(index), Lanes.Broadcast<N>(-1));
        columns.Enter<N>(tile.Column, tile.Width);
        for (var row = 0; row < tile.Height; row++, first += step)
        {
            var upwards = camera.Upwards(Lanes.Broadcast<N>(tile.Row + row));
            for (var next = 0; next < tile.Width; next += N.Count)
            {
                var i = Math.Min(next, tile.Width - N.Count); // the last packet may overlap the one before
                var at = row * Stride + i;
                var hit = miss;
                if (HasAny<N>(at))
                {
                    var direction = camera.Direction(columns.At<N>(i), upwards);
                    var crossings = exact.Cross(new Ray<N>(camera.Position, direction), ref Proposed[at]);
                    hit = N.Or(camera.ClipRange.First(crossings, camera.ZPerT(direction)), miss);
                }
                if (hasDecided)
                {
                    var other = N.Load(decided, at);
                    hit = N.Select(hit <= other, hit, other);
                }
                hit.Store(t, first + i);
                N.Select(hit < miss, some, none).StoreWhole(models, first + i);
            }
        }
    }

    /// <summary>Whether any pixel of a packet has a proposed triangle.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private bool HasAny<N>(int pixel) where N : struct, IPacket<N> => N.Count == 8
        ? Vector256.LoadUnsafe(ref Front[pixel]) != Vector256<float>.Zero
        : Vector128.LoadUnsafe(ref Front[pixel]) != Vector128<float>.Zero;

    /// <summary>Writes the bytes of the tile, in which nothing but the mesh may show.</summary>
    public void Paint(MeshPainter painter, byte[] rgb, int first, int step)
    {
        painter.Paint(tile, Covered, Front, hasDecided ? decided : null, rgb, first, step);
        foreach (var pixel in painter.Doubts.Items)
        {
            if (!hasDecided) decided[pixel] = double.PositiveInfinity;
            if (Front[pixel] > 0) exact.Add(tile.Column + pixel % Stride, tile.Row + pixel / Stride, Proposed[pixel], pixel, decided, Covered);
        }
        exact.Flush(decided, Covered);
        foreach (var pixel in painter.Doubts.Items) painter.Write(pixel, decided[pixel]);
    }
}
