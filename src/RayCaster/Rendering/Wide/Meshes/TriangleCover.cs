using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace RayCaster;

/// <summary>One thread's tool: covers the pixels of a tile with triangles.</summary>
internal sealed class TriangleCover(ScreenSpace screen, TilePixels pixels)
{
    /// <summary>Triangles whose boxes have at most as many samples a side are small.</summary>
    public const int SmallSide = 3;

    private readonly int[] pixelOfLane = new int[8];
    private readonly float[] upperOfLane = new float[8], lowerOfLane = new float[8];
    private readonly float[] unsureUppers = new float[TilePixels.Size]; // of the triangle at work: packets with pixels that are not sure
    private readonly int[] unsurePixels = new int[TilePixels.Size / 8];
    private readonly uint[] unsureLanes = new uint[TilePixels.Size / 8];
    private readonly float[] setup = new float[TriangleSetUp.Length];
    private Tile tile;
    private Vector256<float> greatestW;

    /// <summary>No triangle of the tile has a greater w.</summary>
    public float GreatestW
    {
        get
        {
            var greatest = 0f;
            for (var i = 0; i < 8; i++) greatest = Math.Max(greatest, greatestW[i]);
            return greatest;
        }
    }

    /// <summary>Comes to a tile.</summary>
    public void Enter(in Tile tile) => (this.tile, greatestW) = (tile, Vector256<float>.Zero);

    /// <summary>Takes small triangles, eight at once.</summary>
    public void AddSmall(WaitingTriangles triangles)
    {
        for (var first = 0; first < triangles.Count; first += 8)
        {
            CoverSmall(ref Unsafe.Add(ref triangles.Triangle, first), SetUp(triangles, first));
            pixels.DecideIfMany();
        }
        triangles.Clear();
    }

    /// <summary>Takes triangles of any size, one by one.</summary>
    public void AddLarge(WaitingTriangles triangles)
    {
        for (var first = 0; first < triangles.Count; first += 8)
        {
            for (var shows = SetUp(triangles, first); shows != 0; shows &= shows - 1)
            {
                var i = BitOperations.TrailingZeroCount(shows);
                Cover(Unsafe.Add(ref triangles.Triangle, first + i), i);
            }
            pixels.DecideIfMany();
        }
        triangles.Clear();
    }

    private uint SetUp(WaitingTriangles triangles, int first)
    {
        var shows = TriangleSetUp.Of(triangles, first, screen, tile, setup);
        greatestW = Vector256.MaxNative(greatestW, Field(ref setup[0], TriangleSetUp.MostW));
        return triangles.Count - first < 8 ? shows & ((1u << (triangles.Count - first)) - 1) : shows;
    }

    /// <summary>Takes eight small triangles, sample by sample of their boxes.</summary>
    /// <param name="triangle">The first of the mesh's triangles, which the others follow.</param>
    /// <param name="shows">Which of them to look at.</param>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private void CoverSmall(ref int triangle, uint shows)
    {
        ref var s = ref MemoryMarshal.GetArrayDataReference(setup);
        ref var coveredAt = ref MemoryMarshal.GetArrayDataReference(pixels.Covered);
        ref var frontAt = ref MemoryMarshal.GetArrayDataReference(pixels.Front);
        ref var proposedAt = ref MemoryMarshal.GetArrayDataReference(pixels.Proposed);
        ref var pixelAt = ref MemoryMarshal.GetArrayDataReference(pixelOfLane);
        ref var uppers = ref MemoryMarshal.GetArrayDataReference(upperOfLane);
        ref var lowers = ref MemoryMarshal.GetArrayDataReference(lowerOfLane);
        var (left, bottom) = (Field(ref s, TriangleSetUp.Left), Field(ref s, TriangleSetUp.Bottom));
        var (across, upwards) = (Field(ref s, TriangleSetUp.Right) - left, Field(ref s, TriangleSetUp.Top) - bottom);
        var firstPixel = Vector256.ConvertToInt32Native(bottom * Vector256.Create((float)TilePixels.Stride) + left);
        for (var y = 0; ; y++)
        {
            var up = Vector256.Create((float)y);
            var inRow = shows & Vector256.GreaterThanOrEqual(upwards, up).ExtractMostSignificantBits();
            if (inRow == 0) return;
            var rowU = Field(ref s, TriangleSetUp.U) + up * Field(ref s, TriangleSetUp.U + 2);
            var rowV = Field(ref s, TriangleSetUp.V) + up * Field(ref s, TriangleSetUp.V + 2);
            var rowW = Field(ref s, TriangleSetUp.W) + up * Field(ref s, TriangleSetUp.W + 2);
            for (var x = 0; ; x++)
            {
                var right = Vector256.Create((float)x);
                var bits = inRow & Vector256.GreaterThanOrEqual(across, right).ExtractMostSignificantBits();
                if (bits == 0) break;
                var inner = Vector256.MinNative(
                    Vector256.MultiplyAddEstimate(right, Field(ref s, TriangleSetUp.U + 1), rowU),
                    Vector256.MinNative(
                        Vector256.MultiplyAddEstimate(right, Field(ref s, TriangleSetUp.V + 1), rowV),
                        Vector256.MultiplyAddEstimate(right, Field(ref s, TriangleSetUp.W + 1), rowW)));
                bits &= Vector256.GreaterThanOrEqual(inner, Field(ref s, TriangleSetUp.Outside)).ExtractMostSignificantBits();
                if (bits == 0) continue;

                var nearness = Vector256.MultiplyAddEstimate(right, Field(ref s, TriangleSetUp.Depth + 1),
                    Vector256.MultiplyAddEstimate(up, Field(ref s, TriangleSetUp.Depth + 2), Field(ref s, TriangleSetUp.Depth)));
                var slack = Field(ref s, TriangleSetUp.Slack);
                var covers = Vector256.GreaterThan(inner, Field(ref s, TriangleSetUp.Inside));
                Vector256.MinNative(nearness + slack, Field(ref s, TriangleSetUp.MostW)).StoreUnsafe(ref uppers);
                Vector256.ConditionalSelect(covers, Vector256.MaxNative(nearness - slack, Field(ref s, TriangleSetUp.LeastW)), Vector256.Create(-1f))
                    .StoreUnsafe(ref lowers);
                (firstPixel + Vector256.Create(y * TilePixels.Stride + x)).StoreUnsafe(ref pixelAt);
                for (; bits != 0; bits &= bits - 1)
                {
                    var i = BitOperations.TrailingZeroCount(bits);
                    var (pixel, mostW, leastW) = (Unsafe.Add(ref pixelAt, i), Unsafe.Add(ref uppers, i), Unsafe.Add(ref lowers, i));
                    ref var sure = ref Unsafe.Add(ref coveredAt, pixel);
                    if (mostW < sure) continue;
                    ref var before = ref Unsafe.Add(ref frontAt, pixel);
                    if (leastW > before)
                    {
                        before = mostW;
                        Unsafe.Add(ref proposedAt, pixel) = Unsafe.Add(ref triangle, i);
                    }
                    else
                    {
                        pixels.Enqueue(pixel, Unsafe.Add(ref triangle, i), mostW);
                    }
                    if (leastW > sure) sure = leastW;
                }
            }
        }
    }

    /// <summary>Takes one triangle, eight pixels of a row at a time.</summary>
    /// <param name="triangle">The mesh's triangle.</param>
    /// <param name="lane">Its place in the set-up.</param>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private void Cover(int triangle, int lane)
    {
        ref var s = ref setup[lane];
        float At(ref float of, int field) => Unsafe.Add(ref of, 8 * field);

        var lanes = Vector256.Create(0f, 1, 2, 3, 4, 5, 6, 7);
        int Whole(ref float of, int field) => float.ConvertToIntegerNative<int>(At(ref of, field));

        var (left, right) = (Whole(ref s, TriangleSetUp.Left), Whole(ref s, TriangleSetUp.Right));
        var (bottom, top) = (Whole(ref s, TriangleSetUp.Bottom), Whole(ref s, TriangleSetUp.Top));
        var upU = Vector256.Create(At(ref s, TriangleSetUp.U + 2));
        var upV = Vector256.Create(At(ref s, TriangleSetUp.V + 2));
        var upW = Vector256.Create(At(ref s, TriangleSetUp.W + 2));
        var upDepth = Vector256.Create(At(ref s, TriangleSetUp.Depth + 2));
        var slack = Vector256.Create(At(ref s, TriangleSetUp.Slack));
        var most = Vector256.Create(At(ref s, TriangleSetUp.MostW));
        var least = Vector256.Create(At(ref s, TriangleSetUp.LeastW));
        var outside = Vector256.Create(At(ref s, TriangleSetUp.Outside));
        var inside = Vector256.Create(At(ref s, TriangleSetUp.Inside));
        var name = Vector256.Create(triangle);
        ref var uppers = ref MemoryMarshal.GetArrayDataReference(unsureUppers);
        ref var pixelAt = ref MemoryMarshal.GetArrayDataReference(unsurePixels);
        ref var unsureAt = ref MemoryMarshal.GetArrayDataReference(unsureLanes);
        var count = 0;

        ref var coveredAt = ref MemoryMarshal.GetArrayDataReference(pixels.Covered);
        ref var frontAt = ref MemoryMarshal.GetArrayDataReference(pixels.Front);
        ref var proposedAt = ref MemoryMarshal.GetArrayDataReference(pixels.Proposed);
        for (var x = 0; x <= right - left; x += 8)
        {
            var across = lanes + Vector256.Create((float)x);
            var inBox = Vector256.LessThanOrEqual(across, Vector256.Create((float)(right - left)));
            var u = Vector256.Create(At(ref s, TriangleSetUp.U)) + across * At(ref s, TriangleSetUp.U + 1);
            var v = Vector256.Create(At(ref s, TriangleSetUp.V)) + across * At(ref s, TriangleSetUp.V + 1);
            var w = Vector256.Create(At(ref s, TriangleSetUp.W)) + across * At(ref s, TriangleSetUp.W + 1);
            var depth = Vector256.Create(At(ref s, TriangleSetUp.Depth)) + across * At(ref s, TriangleSetUp.Depth + 1);
            var pixel = bottom * TilePixels.Stride + left + x;
            for (var y = 0; y <= top - bottom; y++, pixel += TilePixels.Stride)
            {
                var up = Vector256.Create((float)y);
                var inner = Vector256.MinNative(Vector256.MultiplyAddEstimate(up, upU, u),
                    Vector256.MinNative(Vector256.MultiplyAddEstimate(up, upV, v), Vector256.MultiplyAddEstimate(up, upW, w)));
                var nearness = Vector256.MultiplyAddEstimate(up, upDepth, depth);
                var upper = Vector256.MinNative(nearness + slack, most);
                var sure = Vector256.LoadUnsafe(ref Unsafe.Add(ref coveredAt, pixel));
                var possible = inBox & Vector256.GreaterThanOrEqual(inner, outside) & Vector256.GreaterThanOrEqual(upper, sure);
                if (possible == Vector256<float>.Zero) continue;

                var covers = possible & Vector256.GreaterThan(inner, inside);
                var lower = Vector256.MaxNative(nearness - slack, least);
                var before = Vector256.LoadUnsafe(ref Unsafe.Add(ref frontAt, pixel));
                var wins = covers & Vector256.GreaterThan(lower, before);
                Vector256.ConditionalSelect(covers, Vector256.MaxNative(sure, lower), sure).StoreUnsafe(ref Unsafe.Add(ref coveredAt, pixel));
                Vector256.ConditionalSelect(wins, upper, before).StoreUnsafe(ref Unsafe.Add(ref frontAt, pixel));
                Vector256.ConditionalSelect(wins.AsInt32(), name, Vector256.LoadUnsafe(ref Unsafe.Add(ref proposedAt, pixel)))
                    .StoreUnsafe(ref Unsafe.Add(ref proposedAt, pixel));

                var unsure = Vector256.AndNot(possible, wins).ExtractMostSignificantBits();
                if (unsure == 0) continue;
                upper.StoreUnsafe(ref Unsafe.Add(ref uppers, 8 * count)); // a call here would put all that is in registers on the stack
                (Unsafe.Add(ref unsureAt, count), Unsafe.Add(ref pixelAt, count)) = (unsure, pixel);
                count++;
            }
        }
        if (count > 0) pixels.Enqueue(triangle, count, unsurePixels, unsureLanes, unsureUppers);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<float> Field(ref float setup, int field) => Vector256.LoadUnsafe(ref Unsafe.Add(ref setup, 8 * field));
}
