using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace RayCaster;

/// <summary>
/// One thread's tool for one tile after another: for each pixel the triangle that may be in front there. A triangle that surely covers a pixel hides all that
/// is surely behind it; where two are too close to each other or a sample too close to a side, the second one waits in a queue for its formula.
/// </summary>
internal sealed class TileFilter
{
    /// <summary>From a pixel to the one above it; there is room for blocks that stand out to the right.</summary>
    public const int Stride = Tile.MaxSide + 8;

    private const int Size = Stride * (Tile.MaxSide + 1);
    private const int QueueLength = 1 << 14;

    private readonly ScreenSpace screen;
    private readonly ExactHits exact;
    private readonly float[] covered = new float[Size];   // a hit with at least this w is sure; 0 for none
    private readonly float[] front = new float[Size];     // the w of the proposed triangle is at most this; 0 where there is none
    private readonly int[] proposed = new int[Size];      // the triangle; −1 for none
    private readonly double[] decided = new double[Size + Packet.Count]; // the least t of the hits that had to be decided by the formula
    private readonly GrowingArray<(int Pixel, int Triangle, float MostW)> queue = new();
    private readonly float[] setup = new float[TriangleSetUp.Length];
    private Tile tile;
    private bool isEmpty, hasDecided;
    private float greatestW;

    public TileFilter(ScreenSpace screen, Vector3[] vertices, int[] indices)
    {
        (this.screen, exact) = (screen, new(screen.Camera, vertices, indices));
    }

    /// <summary>Finds the pixels' triangles.</summary>
    public Reach Enter(in Tile tile, ScreenTriangles[] sets)
    {
        this.tile = tile;
        isEmpty = true;
        hasDecided = false;
        greatestW = 0;
        foreach (var set in sets)
        {
            // Most of what is seen of a closed mesh faces the camera with the same side; that side first, most of the other is found to be hidden.
            Add(set, set.Large);
            var nearer = MeanW(set, set.Of(tile, 0)) < MeanW(set, set.Of(tile, 1)) ? 1 : 0;
            Add(set, set.Of(tile, nearer));
            Add(set, set.Of(tile, 1 - nearer));
            Add(set.SpotsOf(tile));
        }
        if (isEmpty) return Reach.None;
        Decide();
        return new(screen.Unit / greatestW * (1 - 1e-6), Cover());
    }

    /// <summary>Keeps the hits of a part of a row of the tile.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public void Meet(RaySpan span, int index)
    {
        if (isEmpty) return;
        var first = (span.Row - tile.Row) * Stride + span.Column - tile.Column;
        for (var i = 0; i < span.Length; i += Packet.Count)
        {
            var at = first + i;
            var triangles = Vector128.LoadUnsafe(ref proposed[at]);
            if (triangles != Vector128.Create(-1)) span.Keep(i, exact.Hit(span, i, triangles), index);
            if (hasDecided) span.Keep(i, Packet.Load(decided, at), index);
        }
    }

    /// <summary>Every pixel has a sure hit that is not farther than this.</summary>
    private double Cover()
    {
        var least = float.PositiveInfinity;
        for (var row = 0; row < tile.Height; row++)
        {
            foreach (var w in covered.AsSpan(row * Stride, tile.Width)) least = Math.Min(least, w);
            if (least == 0) return double.PositiveInfinity;
        }
        return screen.Unit / least * screen.LongestT * (1 + 1e-6);
    }

    private static float MeanW(ScreenTriangles set, ReadOnlySpan<int> triangles)
    {
        const int Samples = 16;
        var sum = 0f;
        var step = Math.Max(1, triangles.Length / Samples);
        for (var i = 0; i < triangles.Length; i += step) sum += set.Points[set.Indices[3 * triangles[i]]][2];
        return sum * step / Math.Max(1, triangles.Length);
    }

    private void Clear()
    {
        isEmpty = false;
        covered.AsSpan().Clear();
        front.AsSpan().Clear();
        proposed.AsSpan().Fill(-1);
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void Add(ScreenTriangles set, ReadOnlySpan<int> triangles)
    {
        if (triangles.Length == 0) return;
        if (isEmpty) Clear();
        Span<int> ids = stackalloc int[8];
        for (var first = 0; first < triangles.Length; first += 8)
        {
            for (var i = 0; i < 8; i++) ids[i] = triangles[Math.Min(first + i, triangles.Length - 1)];
            var shows = TriangleSetUp.Of(new EightTriangles(set.Points, set.Indices, ids), screen, tile, setup);
            if (triangles.Length - first < 8) shows &= (1u << (triangles.Length - first)) - 1;
            for (; shows != 0; shows &= shows - 1)
            {
                var i = BitOperations.TrailingZeroCount(shows);
                Cover(set.Owners?[ids[i]] ?? ids[i], i);
            }
            if (queue.Count > QueueLength) Decide();
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void Add(ReadOnlySpan<Spot> spots)
    {
        if (spots.Length == 0) return;
        if (isEmpty) Clear();
        var (first, end) = (tile.Row % Tile.MaxSide * Stride, tile.Height * Stride); // of a whole tile this one may have only some rows
        foreach (ref readonly var spot in spots)
        {
            var pixel = spot.Pixel - first;
            if ((uint)pixel >= (uint)end || spot.MostW < covered[pixel]) continue;
            greatestW = Math.Max(greatestW, spot.MostW);
            if (spot.LeastW > front[pixel])
            {
                front[pixel] = spot.MostW;
                proposed[pixel] = spot.Triangle;
            }
            else
            {
                queue.Add((pixel, spot.Triangle, spot.MostW));
            }
            covered[pixel] = Math.Max(covered[pixel], spot.LeastW);
            if (queue.Count > QueueLength) Decide();
        }
    }

    /// <summary>Takes one triangle, block by block of 4 × 2 pixels.</summary>
    /// <param name="triangle">The mesh's triangle.</param>
    /// <param name="lane">Its place in the set-up.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void Cover(int triangle, int lane)
    {
        ref var s = ref setup[lane];
        float At(ref float of, int field) => Unsafe.Add(ref of, 8 * field);

        var laneX = Vector256.Create(0f, 1, 2, 3, 0, 1, 2, 3);
        var laneY = Vector256.Create(0f, 0, 0, 0, 1, 1, 1, 1);
        var (left, right) = ((int)At(ref s, TriangleSetUp.Left), (int)At(ref s, TriangleSetUp.Right));
        var (bottom, top) = ((int)At(ref s, TriangleSetUp.Bottom), (int)At(ref s, TriangleSetUp.Top));
        var (stepU, stepV) = (At(ref s, TriangleSetUp.U + 1), At(ref s, TriangleSetUp.V + 1));
        var (stepW, stepDepth) = (At(ref s, TriangleSetUp.W + 1), At(ref s, TriangleSetUp.Depth + 1));
        var (upU, upV) = (At(ref s, TriangleSetUp.U + 2), At(ref s, TriangleSetUp.V + 2));
        var (upW, upDepth) = (At(ref s, TriangleSetUp.W + 2), At(ref s, TriangleSetUp.Depth + 2));
        var u = Vector256.Create(At(ref s, TriangleSetUp.U)) + laneX * stepU + laneY * upU;
        var v = Vector256.Create(At(ref s, TriangleSetUp.V)) + laneX * stepV + laneY * upV;
        var w = Vector256.Create(At(ref s, TriangleSetUp.W)) + laneX * stepW + laneY * upW;
        var depth = Vector256.Create(At(ref s, TriangleSetUp.Depth)) + laneX * stepDepth + laneY * upDepth;
        var slack = Vector256.Create(At(ref s, TriangleSetUp.Slack));
        var most = Vector256.Create(At(ref s, TriangleSetUp.MostW));
        var least = Vector256.Create(At(ref s, TriangleSetUp.LeastW));
        var outside = Vector256.Create(At(ref s, TriangleSetUp.Outside));
        var inside = Vector256.Create(At(ref s, TriangleSetUp.Inside));
        greatestW = Math.Max(greatestW, most[0]);

        ref var coveredAt = ref MemoryMarshal.GetArrayDataReference(covered);
        ref var frontAt = ref MemoryMarshal.GetArrayDataReference(front);
        ref var proposedAt = ref MemoryMarshal.GetArrayDataReference(proposed);
        for (var y = 0; y <= top - bottom; y += 2)
        {
            for (var x = 0; x <= right - left; x += 4)
            {
                var pixel = (bottom + y) * Stride + left + x;
                var nearness = depth + Vector256.Create(x * stepDepth + y * upDepth);
                var upper = Vector256.MinNative(nearness + slack, most);
                var sure = Load(ref coveredAt, pixel);
                var possible = Vector256.GreaterThanOrEqual(upper, sure)
                    & Vector256.LessThanOrEqual(laneX, Vector256.Create((float)(right - left - x)))
                    & Vector256.LessThanOrEqual(laneY, Vector256.Create((float)(top - bottom - y)));
                if (possible == Vector256<float>.Zero) continue;

                var side = Vector256.MinNative(
                    u + Vector256.Create(x * stepU + y * upU),
                    Vector256.MinNative(v + Vector256.Create(x * stepV + y * upV), w + Vector256.Create(x * stepW + y * upW)));
                possible &= Vector256.GreaterThanOrEqual(side, outside);
                if (possible == Vector256<float>.Zero) continue;

                var covers = possible & Vector256.GreaterThan(side, inside);
                var lower = Vector256.MaxNative(nearness - slack, least);
                var before = Load(ref frontAt, pixel);
                var wins = covers & Vector256.GreaterThan(lower, before);
                Store(Vector256.ConditionalSelect(covers, Vector256.MaxNative(sure, lower), sure), ref coveredAt, pixel);
                Store(Vector256.ConditionalSelect(wins, upper, before), ref frontAt, pixel);
                var names = Load(ref Unsafe.As<int, float>(ref proposedAt), pixel);
                Store(Vector256.ConditionalSelect(wins, Vector256.Create(triangle).AsSingle(), names), ref Unsafe.As<int, float>(ref proposedAt), pixel);

                var unsure = Vector256.AndNot(possible, wins).ExtractMostSignificantBits();
                if (unsure != 0) Enqueue(unsure, pixel, triangle, upper);
            }
        }
    }

    private void Enqueue(uint lanes, int pixel, int triangle, Vector256<float> upper)
    {
        for (; lanes != 0; lanes &= lanes - 1)
        {
            var i = BitOperations.TrailingZeroCount(lanes);
            queue.Add((pixel + i % 4 + i / 4 * Stride, triangle, upper[i]));
        }
    }

    /// <summary>Asks the formula about what waits and may still be in front.</summary>
    private void Decide()
    {
        if (queue.Count == 0) return;
        if (!hasDecided) decided.AsSpan().Fill(double.PositiveInfinity);
        hasDecided = true;
        foreach (var (pixel, triangle, mostW) in queue.Items)
        {
            if (mostW < covered[pixel]) continue;
            exact.Add(tile.Column + pixel % Stride, tile.Row + pixel / Stride, triangle, pixel, decided);
        }
        exact.Flush(decided);
        queue.Clear();
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<float> Load(ref float numbers, int pixel) => Vector256.Create(
        Vector128.LoadUnsafe(ref Unsafe.Add(ref numbers, pixel)), Vector128.LoadUnsafe(ref Unsafe.Add(ref numbers, pixel + Stride)));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Store(Vector256<float> block, ref float numbers, int pixel)
    {
        block.GetLower().StoreUnsafe(ref Unsafe.Add(ref numbers, pixel));
        block.GetUpper().StoreUnsafe(ref Unsafe.Add(ref numbers, pixel + Stride));
    }
}
