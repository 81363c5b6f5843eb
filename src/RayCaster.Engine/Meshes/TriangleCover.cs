using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace RayCaster.Engine;

/// <summary>One thread's tool: covers the pixels of a tile with triangles.</summary>
/// <remarks>
/// Every second sample of a small box is outside or hidden, and no processor foresees which. So pixels are written whether or not anything changes; only what is
/// not sure, which is rare, has a branch. In a large box what is outside lies together.
/// </remarks>
internal sealed class TriangleCover(ScreenSpace screen, TilePixels pixels)
{
    /// <summary>Triangles whose boxes have at most as many samples a side are small.</summary>
    public const int SmallSide = 2;

    /// <summary>Those with at least as many on one side are large: most of the box of a long one is outside.</summary>
    private const int LargeSide = 24;

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
            Cover(ref Unsafe.Add(ref triangles.Triangle, first), SetUp(triangles, first));
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

    /// <summary>Takes eight small triangles that are set up, sample by sample of their boxes.</summary>
    /// <param name="triangle">The first of the mesh's triangles, which the others follow.</param>
    /// <param name="shows">Which of them to look at.</param>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private void CoverSmall(ref int triangle, uint shows)
    {
        ref var s = ref MemoryMarshal.GetArrayDataReference(setup);
        ref var coveredAt = ref MemoryMarshal.GetArrayDataReference(pixels.Covered);
        ref var frontAt = ref MemoryMarshal.GetArrayDataReference(pixels.Front);
        ref var proposedAt = ref MemoryMarshal.GetArrayDataReference(pixels.Proposed);
        ref var uppers = ref MemoryMarshal.GetArrayDataReference(upperOfLane);
        ref var lowers = ref MemoryMarshal.GetArrayDataReference(lowerOfLane);
        var (width, height) = (Field(ref s, TriangleSetUp.Across).AsInt32(), Field(ref s, TriangleSetUp.Upwards).AsInt32());
        for (var y = 0; ; y++)
        {
            var up = Vector256.Create((float)y);
            var inRow = shows & Vector256.GreaterThanOrEqual(height, Vector256.Create(y)).ExtractMostSignificantBits();
            if (inRow == 0) return;
            for (var x = 0; ; x++)
            {
                var right = Vector256.Create((float)x);
                var bits = inRow & Vector256.GreaterThanOrEqual(width, Vector256.Create(x)).ExtractMostSignificantBits();
                if (bits == 0) break;
                var inner = Vector256.MinNative(At(ref s, TriangleSetUp.U, right, up),
                    Vector256.MinNative(At(ref s, TriangleSetUp.V, right, up), At(ref s, TriangleSetUp.W, right, up)));
                bits &= Vector256.GreaterThanOrEqual(inner, Field(ref s, TriangleSetUp.Outside)).ExtractMostSignificantBits();

                var (nearness, slack) = (At(ref s, TriangleSetUp.Depth, right, up), Field(ref s, TriangleSetUp.Slack));
                var covers = Vector256.GreaterThan(inner, Field(ref s, TriangleSetUp.Inside));
                Vector256.MinNative(nearness + slack, Field(ref s, TriangleSetUp.MostW)).StoreUnsafe(ref uppers);
                (covers & Vector256.MaxNative(nearness - slack, Field(ref s, TriangleSetUp.LeastW))).StoreUnsafe(ref lowers);
                for (; bits != 0; bits &= bits - 1)
                {
                    var i = BitOperations.TrailingZeroCount(bits);
                    var (pixel, name) = (Whole(ref Unsafe.Add(ref s, i), TriangleSetUp.Pixel) + y * TilePixels.Stride + x, Unsafe.Add(ref triangle, i));
                    ref var coveredHere = ref Unsafe.Add(ref coveredAt, pixel);
                    ref var frontHere = ref Unsafe.Add(ref frontAt, pixel);
                    ref var proposedHere = ref Unsafe.Add(ref proposedAt, pixel);
                    var (upper, lower) = (Vector128.CreateScalarUnsafe(Unsafe.Add(ref uppers, i)), Vector128.CreateScalarUnsafe(Unsafe.Add(ref lowers, i)));
                    var (sure, before) = (Vector128.CreateScalarUnsafe(coveredHere), Vector128.CreateScalarUnsafe(frontHere));
                    var possible = Vector128.GreaterThanOrEqual(upper, sure);
                    var wins = possible & Vector128.GreaterThan(lower, before);
                    coveredHere = Vector128.MaxNative(sure, lower).ToScalar();
                    frontHere = Vector128.ConditionalSelect(wins, upper, before).ToScalar();
                    proposedHere = Vector128.ConditionalSelect(wins.AsInt32(), Vector128.CreateScalarUnsafe(name), Vector128.CreateScalarUnsafe(proposedHere)).ToScalar();
                    if (Vector128.AndNot(possible, wins).AsInt32().ToScalar() != 0) pixels.Enqueue(pixel, name, upper.ToScalar());
                }
            }
        }
    }

    /// <summary>A function at a sample of each triangle's box.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<float> At(ref float setup, int field, Vector256<float> right, Vector256<float> up) => Vector256.MultiplyAddEstimate(
        up, Field(ref setup, field + 2), Vector256.MultiplyAddEstimate(right, Field(ref setup, field + 1), Field(ref setup, field)));

    /// <summary>Takes the triangles that are set up, eight pixels of two rows at a time.</summary>
    /// <param name="triangle">The first of the mesh's triangles, which the others follow.</param>
    /// <param name="shows">Which of them to look at.</param>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private void Cover(ref int triangle, uint shows)
    {
        ref var fields = ref MemoryMarshal.GetArrayDataReference(setup);
        ref var uppers = ref MemoryMarshal.GetArrayDataReference(unsureUppers);
        ref var pixelAt = ref MemoryMarshal.GetArrayDataReference(unsurePixels);
        ref var unsureAt = ref MemoryMarshal.GetArrayDataReference(unsureLanes);
        ref var coveredAt = ref MemoryMarshal.GetArrayDataReference(pixels.Covered);
        ref var frontAt = ref MemoryMarshal.GetArrayDataReference(pixels.Front);
        ref var proposedAt = ref MemoryMarshal.GetArrayDataReference(pixels.Proposed);
        for (; shows != 0; shows &= shows - 1)
        {
            var lane = BitOperations.TrailingZeroCount(shows);
            ref var s = ref Unsafe.Add(ref fields, lane);
            var name = Vector512.Create(Unsafe.Add(ref triangle, lane));
            var (first, width, height) = (Whole(ref s, TriangleSetUp.Pixel), Whole(ref s, TriangleSetUp.Across), Whole(ref s, TriangleSetUp.Upwards));
            var isLarge = Math.Max(width, height) >= LargeSide;
            var count = 0;
            for (var x = 0; x <= width; x += 8)
            {
                var across = Vector512.Create(0f, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7) + Vector512.Create((float)x);
                var inBox = Vector512.LessThanOrEqual(across, Vector512.Create((float)width));
                var u = All(ref s, TriangleSetUp.U) + across * All(ref s, TriangleSetUp.U + 1);
                var v = All(ref s, TriangleSetUp.V) + across * All(ref s, TriangleSetUp.V + 1);
                var w = All(ref s, TriangleSetUp.W) + across * All(ref s, TriangleSetUp.W + 1);
                var depth = All(ref s, TriangleSetUp.Depth) + across * All(ref s, TriangleSetUp.Depth + 1);
                var (upU, upV, upW) = (All(ref s, TriangleSetUp.U + 2), All(ref s, TriangleSetUp.V + 2), All(ref s, TriangleSetUp.W + 2));
                var (upDepth, slack) = (All(ref s, TriangleSetUp.Depth + 2), All(ref s, TriangleSetUp.Slack));
                var (most, least) = (All(ref s, TriangleSetUp.MostW), All(ref s, TriangleSetUp.LeastW));
                var (outside, inside) = (All(ref s, TriangleSetUp.Outside), All(ref s, TriangleSetUp.Inside));
                var up = Vector512.Create(0f, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1);
                var last = Vector512.Create((float)height); // the second of two rows may be beyond it
                var pixel = first + x;
                for (var y = 0; y <= height; y += 2, pixel += 2 * TilePixels.Stride, up += Vector512.Create(2f))
                {
                    var inner = Vector512.MinNative(Vector512.MultiplyAddEstimate(up, upU, u),
                        Vector512.MinNative(Vector512.MultiplyAddEstimate(up, upV, v), Vector512.MultiplyAddEstimate(up, upW, w)));
                    var nearness = Vector512.MultiplyAddEstimate(up, upDepth, depth);
                    var upper = Vector512.MinNative(nearness + slack, most);
                    var lower = Vector512.MaxNative(nearness - slack, least);
                    ref var coveredHere = ref Unsafe.Add(ref coveredAt, pixel);
                    ref var frontHere = ref Unsafe.Add(ref frontAt, pixel);
                    ref var proposedHere = ref Unsafe.Add(ref proposedAt, pixel);
                    var (sure, before) = (Two(ref coveredHere), Two(ref frontHere));
                    var possible = inBox & Vector512.LessThanOrEqual(up, last) & Vector512.GreaterThanOrEqual(inner, outside) & Vector512.GreaterThanOrEqual(upper, sure);
                    if (isLarge && possible == Vector512<float>.Zero) continue;
                    var covers = possible & Vector512.GreaterThan(inner, inside);
                    var wins = covers & Vector512.GreaterThan(lower, before);
                    Store(Vector512.ConditionalSelect(covers, Vector512.MaxNative(sure, lower), sure), ref coveredHere);
                    Store(Vector512.ConditionalSelect(wins, upper, before), ref frontHere);
                    Store(Vector512.ConditionalSelect(wins.AsInt32(), name, Two(ref proposedHere)), ref proposedHere);

                    var unsure = (uint)Vector512.AndNot(possible, wins).ExtractMostSignificantBits();
                    if (unsure == 0) continue;
                    upper.StoreUnsafe(ref Unsafe.Add(ref uppers, 8 * count)); // a call here would put all that is in registers on the stack
                    (Unsafe.Add(ref unsureAt, count), Unsafe.Add(ref pixelAt, count)) = (unsure & 0xFF, pixel);
                    count++;
                    (Unsafe.Add(ref unsureAt, count), Unsafe.Add(ref pixelAt, count)) = (unsure >> 8, pixel + TilePixels.Stride);
                    count++;
                }
            }
            if (count > 0) pixels.Enqueue(Unsafe.Add(ref triangle, lane), count, unsurePixels, unsureLanes, unsureUppers);
        }
    }

    /// <summary>One triangle's number in all lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<float> All(ref float triangle, int field) => Vector512.Create(Unsafe.Add(ref triangle, 8 * field));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static int Whole(ref float triangle, int field) => BitConverter.SingleToInt32Bits(Unsafe.Add(ref triangle, 8 * field));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<T> Two<T>(ref T at) => Vector512.Create(Vector256.LoadUnsafe(ref at), Vector256.LoadUnsafe(ref Unsafe.Add(ref at, TilePixels.Stride)));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Store<T>(Vector512<T> two, ref T at)
    {
        two.GetLower().StoreUnsafe(ref at);
        two.GetUpper().StoreUnsafe(ref Unsafe.Add(ref at, TilePixels.Stride));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<float> Field(ref float setup, int field) => Vector256.LoadUnsafe(ref Unsafe.Add(ref setup, 8 * field));
}
