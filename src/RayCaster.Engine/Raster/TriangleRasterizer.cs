namespace RayCaster.Engine;

/// <summary>Rasterizes triangles in a tile; each thread has its own.</summary>
/// <remarks>
/// The native minima and maxima of the loops treat NaN differently on each processor. It comes only from a triangle with a corner that is NaN, which
/// never covers a sample for certain, and which no ray hits.
/// Every second sample of a small box is outside or hidden, and branch prediction cannot tell which. So pixels are written whether or not anything
/// changes; only uncertain ones, which are rare, take a branch. In a large box samples outside are predictable, so a branch skips them.
/// </remarks>
/// <param name="decide">Decides about all queued pixels.</param>
internal sealed class TriangleRasterizer(ScreenSpace screen, TilePixels pixels, Action decide)
{
    /// <summary>A triangle is small if its box has at most this many samples on each side.</summary>
    public const int SmallSide = 2;

    /// <summary>A triangle is large if its box has at least this many samples on one side: most of a long one's box is outside.</summary>
    private const int LargeSide = 24;

    private readonly float[] upperOfLane = new float[8], lowerOfLane = new float[8];
    private readonly float[] unsureUppers = new float[TilePixels.Size]; // packets of the current triangle with uncertain pixels
    private readonly int[] unsurePixels = new int[TilePixels.Size / 8];
    private readonly uint[] unsureLanes = new uint[TilePixels.Size / 8];
    private TriangleSetUp setup; // of eight triangles
    private PixelRect tile;
    private Vector256<float> maxInverseDepth;

    public float MaxInverseDepth
    {
        get
        {
            var greatest = 0f;
            for (var i = 0; i < 8; i++) greatest = Math.Max(greatest, maxInverseDepth[i]);
            return greatest;
        }
    }

    public void Begin(in PixelRect tile) => (this.tile, maxInverseDepth) = (tile, Vector256<float>.Zero);

    public void AddSmall(TriangleQueue triangles)
    {
        for (var first = 0; first < triangles.Count; first += 8)
        {
            CoverSmall(triangles.Triangles, first, SetUp(triangles, first));
            if (pixels.IsFull) decide();
        }
        triangles.Clear();
    }

    public void AddLarge(TriangleQueue triangles)
    {
        for (var first = 0; first < triangles.Count; first += 8)
        {
            Cover(triangles.Triangles, first, SetUp(triangles, first));
            if (pixels.IsFull) decide();
        }
        triangles.Clear();
    }

    private uint SetUp(TriangleQueue triangles, int first)
    {
        var shows = TriangleSetUp.Of(triangles, first, screen, tile, out setup);
        // In this order NaN, of a corner that is NaN, does not hide the other triangles.
        maxInverseDepth = Lanes.MaxOrLast(setup.MaxInverseDepth, maxInverseDepth);
        return triangles.Count - first < 8 ? shows & ((1u << (triangles.Count - first)) - 1) : shows;
    }

    /// <summary>Covers samples of eight small triangles, one sample of each at a time.</summary>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private void CoverSmall(RawSpan<int> ids, int firstId, uint shows)
    {
        ref readonly var s = ref setup;
        var occluderInverseDepthAt = new RawSpan<float>(pixels.OccluderInverseDepth);
        var candidateInverseDepthAt = new RawSpan<float>(pixels.CandidateInverseDepth);
        var proposedAt = new RawSpan<int>(pixels.Proposed);
        var uppers = new RawSpan<float>(upperOfLane);
        var lowers = new RawSpan<float>(lowerOfLane);
        var (width, height) = (s.Across, s.Upwards);
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
                var inner = Vector256.MinNative(s.E0.At(right, up),
                    Vector256.MinNative(s.E1.At(right, up), s.E2.At(right, up)));
                bits &= Vector256.GreaterThanOrEqual(inner, s.Outside).ExtractMostSignificantBits();

                var inverseDepth = s.InverseDepth.At(right, up);
                var slack = s.Slack;
                var covers = Vector256.GreaterThan(inner, s.Inside);
                uppers.Store(Vector256.MinNative(inverseDepth + slack, s.MaxInverseDepth), 0);
                lowers.Store(covers & Vector256.MaxNative(inverseDepth - slack, s.MinInverseDepth), 0);
                for (; bits != 0; bits &= bits - 1)
                {
                    var i = BitOperations.TrailingZeroCount(bits);
                    var pixel = Lanes.At(s.Pixel, i) + y * TilePixels.Stride + x;
                    var id = ids[firstId + i];
                    ref var occluderHere = ref occluderInverseDepthAt[pixel];
                    ref var candidateHere = ref candidateInverseDepthAt[pixel];
                    ref var proposedHere = ref proposedAt[pixel];
                    var (upper, lower) = (Vector128.CreateScalarUnsafe(uppers[i]), Vector128.CreateScalarUnsafe(lowers[i]));
                    var (sure, before) = (Vector128.CreateScalarUnsafe(occluderHere), Vector128.CreateScalarUnsafe(candidateHere));
                    var possible = Vector128.GreaterThanOrEqual(upper, sure);
                    var wins = possible & Vector128.GreaterThan(lower, before);
                    occluderHere = Vector128.MaxNative(sure, lower).ToScalar();
                    candidateHere = Vector128.ConditionalSelect(wins, upper, before).ToScalar();
                    proposedHere = Vector128.ConditionalSelect(
                        wins.AsInt32(), Vector128.CreateScalarUnsafe(id), Vector128.CreateScalarUnsafe(proposedHere)).ToScalar();
                    if (Vector128.AndNot(possible, wins).AsInt32().ToScalar() != 0) pixels.Enqueue(pixel, id, upper.ToScalar());
                }
            }
        }
    }

    /// <summary>Covers samples of triangles one by one, eight pixels of two rows at a time.</summary>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private void Cover(RawSpan<int> ids, int firstId, uint shows)
    {
        ref readonly var s = ref setup;
        var uppers = new RawSpan<float>(unsureUppers);
        var pixelAt = new RawSpan<int>(unsurePixels);
        var unsureAt = new RawSpan<uint>(unsureLanes);
        var occluderInverseDepthAt = new RawSpan<float>(pixels.OccluderInverseDepth);
        var candidateInverseDepthAt = new RawSpan<float>(pixels.CandidateInverseDepth);
        var proposedAt = new RawSpan<int>(pixels.Proposed);
        for (; shows != 0; shows &= shows - 1)
        {
            var lane = BitOperations.TrailingZeroCount(shows);
            var id = Vector512.Create(ids[firstId + lane]);
            var (first, width, height) = (Lanes.At(s.Pixel, lane), Lanes.At(s.Across, lane), Lanes.At(s.Upwards, lane));
            var isLarge = Math.Max(width, height) >= LargeSide;
            var count = 0;
            for (var x = 0; x <= width; x += 8)
            {
                var across = Vector512.Create(0f, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7) + Vector512.Create((float)x);
                var inBox = Vector512.LessThanOrEqual(across, Vector512.Create((float)width));
                var e0 = s.E0.InLowestRow(lane, across);
                var e1 = s.E1.InLowestRow(lane, across);
                var e2 = s.E2.InLowestRow(lane, across);
                var startInverseDepth = s.InverseDepth.InLowestRow(lane, across);
                var (upE0, upE1, upE2) = (Lanes.Broadcast(s.E0.Up, lane), Lanes.Broadcast(s.E1.Up, lane), Lanes.Broadcast(s.E2.Up, lane));
                var upInverseDepth = Lanes.Broadcast(s.InverseDepth.Up, lane);
                var slack = Lanes.Broadcast(s.Slack, lane);
                var (most, least) = (Lanes.Broadcast(s.MaxInverseDepth, lane), Lanes.Broadcast(s.MinInverseDepth, lane));
                var (outside, inside) = (Lanes.Broadcast(s.Outside, lane), Lanes.Broadcast(s.Inside, lane));
                var up = Vector512.Create(0f, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1);
                var last = Vector512.Create((float)height); // the second of two rows may lie beyond it
                var pixel = first + x;
                // height | 2: at least two rounds, of two rows each. Branch prediction cannot tell whether a small triangle has more than two rows.
                for (var y = 0; y <= (height | 2); y += 2, pixel += 2 * TilePixels.Stride, up += Vector512.Create(2f))
                {
                    var inner = Vector512.MinNative(Vector512.MultiplyAddEstimate(up, upE0, e0),
                        Vector512.MinNative(Vector512.MultiplyAddEstimate(up, upE1, e1), Vector512.MultiplyAddEstimate(up, upE2, e2)));
                    var inverseDepth = Vector512.MultiplyAddEstimate(up, upInverseDepth, startInverseDepth);
                    var upper = Vector512.MinNative(inverseDepth + slack, most);
                    var lower = Vector512.MaxNative(inverseDepth - slack, least);
                    var (sure, before) = (TwoRows(occluderInverseDepthAt, pixel), TwoRows(candidateInverseDepthAt, pixel));
                    var possible = inBox & Vector512.LessThanOrEqual(up, last)
                        & Vector512.GreaterThanOrEqual(inner, outside) & Vector512.GreaterThanOrEqual(upper, sure);
                    if (isLarge && possible == Vector512<float>.Zero) continue;
                    var covers = possible & Vector512.GreaterThan(inner, inside);
                    var wins = covers & Vector512.GreaterThan(lower, before);
                    Store(Vector512.ConditionalSelect(covers, Vector512.MaxNative(sure, lower), sure), occluderInverseDepthAt, pixel);
                    Store(Vector512.ConditionalSelect(wins, upper, before), candidateInverseDepthAt, pixel);
                    Store(Vector512.ConditionalSelect(wins.AsInt32(), id, TwoRows(proposedAt, pixel)), proposedAt, pixel);

                    var unsure = (uint)Vector512.AndNot(possible, wins).ExtractMostSignificantBits();
                    if (unsure == 0) continue;
                    uppers.Store(upper, 8 * count); // a call here would spill all registers
                    (unsureAt[count], pixelAt[count]) = (unsure & 0xFF, pixel);
                    count++;
                    (unsureAt[count], pixelAt[count]) = (unsure >> 8, pixel + TilePixels.Stride);
                    count++;
                }
            }
            if (count > 0) pixels.Enqueue(ids[firstId + lane], count, unsurePixels, unsureLanes, unsureUppers);
        }
    }

    /// <summary>Eight pixels of a row and of the one above it. (With Vector512.Create, the compiler writes both halves into the register of the rows
    /// before, and each step waits for them.)</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<T> TwoRows<T>(RawSpan<T> rows, int pixel) where T : struct =>
        rows.Load256(pixel).ToVector512Unsafe().WithUpper(rows.Load256(pixel + TilePixels.Stride));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Store<T>(Vector512<T> two, RawSpan<T> rows, int pixel) where T : struct
    {
        rows.Store(two.GetLower(), pixel);
        rows.Store(two.GetUpper(), pixel + TilePixels.Stride);
    }
}
