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
    /// <summary>From a pixel to the one above it. What a packet at the end of a row holds of the next one stays as it is.</summary>
    public const int Stride = Tile.MaxSide;

    private const int Size = Stride * Tile.MaxSide + 8;
    private const int QueueLength = 1 << 14;

    /// <summary>Triangles whose boxes have at most as many samples a side are looked at sample by sample, eight triangles at once.</summary>
    private const int SmallSide = 3;

    /// <summary>How many groups are looked at before any of them is drawn, and how many of these their memory is asked for in advance.</summary>
    private const int GroupsAtOnce = 256, Ahead = 4;

    private readonly ScreenSpace screen;
    private readonly ExactHits exact;
    private readonly float[] covered = new float[Size];   // a hit with at least this w is sure; 0 for none
    private readonly float[] front = new float[Size];     // the w of the proposed triangle is at most this; 0 where there is none
    private readonly int[] proposed = new int[Size];      // the triangle; any where there is none
    private readonly double[] decided = new double[Size]; // the least t of the hits that had to be decided by the formula
    private readonly GrowingArray<(int Pixel, int Triangle, float MostW)> queue = new();
    private readonly int[] pixelOfLane = new int[8];
    private readonly float[] upperOfLane = new float[8], lowerOfLane = new float[8];
    private readonly float[] unsureUppers = new float[Size];  // of the triangle at work: packets with pixels that are not sure
    private readonly int[] unsurePixels = new int[Size / 8];
    private readonly uint[] unsureLanes = new uint[Size / 8];
    private readonly float[] setup = new float[TriangleSetUp.Length];
    private readonly Twins twins;
    private readonly CoarseDepth coarse = new();
    private EightTriangles eight;
    private readonly WaitingTriangles waiting = new(), waitingLarge = new();
    private Tile tile;
    private bool isEmpty, hasDecided;
    private Vector256<float> greatestW;

    public TileFilter(ScreenSpace screen, Vector3[] vertices, int[] indices)
    {
        (this.screen, exact, twins) = (screen, new(screen, vertices, indices), new(vertices, indices));
    }

    /// <summary>Finds the pixels' triangles.</summary>
    public Reach Enter(in Tile tile, ScreenTriangles[] sets)
    {
        this.tile = tile;
        isEmpty = true;
        hasDecided = false;
        greatestW = Vector256<float>.Zero;
        foreach (var set in sets)
        {
            // Most of what is seen of a closed mesh faces the camera with the same side; that side first, most of the other is found to be hidden.
            Add(set, CollectionsMarshal.AsSpan(set.Large));
            var nearer = MeanW(set, tile, 0) < MeanW(set, tile, 1) ? 1 : 0;
            Add(set, set.GroupsOf(tile, nearer));
            Add(set, set.Of(tile, nearer));
            if (!isEmpty)
            {
                Decide(); // one pixel that is not sure to be covered would let through all that may lie in its cell
                coarse.Update(covered);
            }
            Add(set, set.GroupsOf(tile, 1 - nearer));
            Add(set, set.Of(tile, 1 - nearer));
        }
        if (isEmpty) return Reach.None;
        Decide();
        coarse.Update(covered);
        var greatest = 0f;
        for (var i = 0; i < 8; i++) greatest = Math.Max(greatest, greatestW[i]);
        var least = coarse.Least;
        return new(screen.Unit / greatest * (1 - 1e-6), least > 0 ? screen.Unit / least * screen.LongestT * (1 + 1e-6) : double.PositiveInfinity);
    }

    /// <summary>Keeps the hits of a part of a row of the tile.</summary>
    public void Meet(RaySpan span, int index)
    {
        if (isEmpty) return;
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
            var any = N.Count == 8 ? Vector256.LoadUnsafe(ref front[at]) : Vector256.Create(Vector128.LoadUnsafe(ref front[at]), default);
            var hit = RaySpan.All<N>(double.NaN);
            if (any != Vector256<float>.Zero) hit = exact.Hit<N>(span, i, ref proposed[at]);
            if (hasDecided)
            {
                var other = N.Load(decided, at);
                hit = N.Select(hit <= other, hit, other);
            }
            span.Keep(i, hit, RaySpan.All<N>(index));
        }
    }

    /// <summary>Writes the bytes of the tile, in which nothing but the mesh may show.</summary>
    public void Paint(MeshPainter painter, byte[] rgb, int first, int step)
    {
        painter.Paint(tile, covered, front, hasDecided ? decided : null, rgb, first, step);
        foreach (var pixel in painter.Doubts.Items)
        {
            if (!hasDecided) decided[pixel] = double.PositiveInfinity;
            if (front[pixel] > 0) exact.Add(tile.Column + pixel % Stride, tile.Row + pixel / Stride, proposed[pixel], pixel, decided, covered);
        }
        exact.Flush(decided, covered);
        foreach (var pixel in painter.Doubts.Items) painter.Write(pixel, decided[pixel]);
    }

    private static float MeanW(ScreenTriangles set, in Tile tile, int side)
    {
        const int Samples = 8;
        var sum = 0f;
        if (set.GroupsOf(tile, side) is { Length: > 0 } groups)
        {
            var step = (groups.Length + Samples - 1) / Samples;
            for (var i = 0; i < groups.Length; i += step) sum += groups[i].MostW;
            return sum / ((groups.Length + step - 1) / step);
        }
        if (set.Of(tile, side) is not { Length: > 0 } triangles) return 0;
        Span<int> ids = stackalloc int[Samples];
        for (var i = 0; i < Samples; i++) ids[i] = triangles[(int)((long)i * triangles.Length / Samples)];
        set.Corners.See(ids, out var seen);
        return Vector256.Sum(seen.A.W) / Samples;
    }

    /// <summary>Forgets all; beyond the tile's pixels everything is covered, so that they do not count where the least is looked for.</summary>
    private void Clear()
    {
        isEmpty = false;
        coarse.Clear();
        twins.Clear();
        covered.AsSpan().Clear();
        front.AsSpan().Clear();
        proposed.AsSpan().Clear();
        for (var row = 0; row < Tile.MaxSide; row++)
            covered.AsSpan(row * Stride, Stride)[(row < tile.Height ? tile.Width : 0)..].Fill(float.PositiveInfinity);
    }

    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private void Add(ScreenTriangles set, ReadOnlySpan<Group> groups)
    {
        if (groups.Length == 0) return;
        if (isEmpty) Clear();
        var firstRow = tile.Row % Tile.MaxSide;
        var corners = set.Corners;
        Span<int> seen = stackalloc int[GroupsAtOnce];
        for (var next = 0; next < groups.Length;)
        {
            var count = 0;
            for (; next < groups.Length && count < seen.Length; next++)
                if (!coarse.Hides(groups[next].Cells, firstRow, groups[next].MostW))
                    seen[count++] = groups[next].First;

            // A group's indices and vertices lie anywhere; to wait for them would take longer than all that is computed.
            for (var i = -Ahead; i < count; i++)
            {
                if (i + Ahead < count) corners.Fetch(seen[i + Ahead]);
                if (i + Ahead / 2 is >= 0 and var near && near < count) corners.FetchVertices(seen[near]);
                if (i >= 0) Add(set, seen[i]);
            }
        }
        AddWaiting();
    }

    private void Add(ScreenTriangles set, int group)
    {
        var end = Math.Min(group + Group.Length, set.Corners.Count);
        for (var first = group; first < end; first += 8)
        {
            set.Corners.SeeRun(first, out eight);
            Add(set, Vector256.Create(first) + Vector256<int>.Indices, end - first);
        }
    }

    private void Add(ScreenTriangles set, ReadOnlySpan<int> triangles)
    {
        if (triangles.Length == 0) return;
        if (isEmpty) Clear();
        Span<int> ids = stackalloc int[8];
        for (var first = 0; first < triangles.Length; first += 8)
        {
            for (var i = 0; i < 8; i++) ids[i] = triangles[Math.Min(first + i, triangles.Length - 1)];
            set.Corners.See(ids, out eight);
            Add(set, Vector256.Create<int>(ids), triangles.Length - first);
        }
        AddWaiting();
    }

    /// <summary>Takes the eight triangles that are seen, or less: those in whose boxes are samples wait.</summary>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private void Add(ScreenTriangles set, Vector256<int> names, int count)
    {
        ref readonly var t = ref eight;
        var margin = Vector256.Create(screen.Margin);
        var (column, row) = (Vector256.Create((float)tile.Column), Vector256.Create((float)tile.Row));
        var (minX, maxX) = (Lanes.Least(t.A.X, t.B.X, t.C.X), Lanes.Most(t.A.X, t.B.X, t.C.X));
        var (minY, maxY) = (Lanes.Least(t.A.Y, t.B.Y, t.C.Y), Lanes.Most(t.A.Y, t.B.Y, t.C.Y));
        var left = Vector256.MaxNative(Vector256.Ceiling(minX - margin), column);
        var right = Vector256.MinNative(Vector256.Floor(maxX + margin), column + Vector256.Create(tile.Width - 1f));
        var bottom = Vector256.MaxNative(Vector256.Ceiling(minY - margin), row);
        var top = Vector256.MinNative(Vector256.Floor(maxY + margin), row + Vector256.Create(tile.Height - 1f));
        var isSingle = Vector256.Equals(left, right) & Vector256.Equals(bottom, top);
        var passes = TriangleSetUp.Pass(t, left, bottom, maxX - minX + (maxY - minY), margin, out _);
        var shows = Vector256.AndNot(Vector256.LessThanOrEqual(left, right) & Vector256.LessThanOrEqual(bottom, top), isSingle & passes)
            .ExtractMostSignificantBits();
        if (count < 8) shows &= (1u << count) - 1;
        if (shows == 0) return;
        if (set.Owners is { } owners)
            for (var i = 0; i < 8; i++)
                names = names.WithElement(i, owners[Math.Min(names[i], owners.Length - 1)]);

        var side = Vector256.Create((float)SmallSide);
        var small = (Vector256.LessThan(right - left, side) & Vector256.LessThan(top - bottom, side)).ExtractMostSignificantBits();
        if ((shows & small) != 0)
        {
            waiting.Add(t, names, shows & small);
            if (waiting.IsFull) AddSmall();
        }
        if ((shows & ~small) != 0)
        {
            waitingLarge.Add(t, names, shows & ~small);
            if (waitingLarge.IsFull) AddLarge();
        }
    }

    private void AddWaiting()
    {
        if (waiting.Count > 0) AddSmall();
        if (waitingLarge.Count > 0) AddLarge();
    }

    private void AddSmall()
    {
        for (var first = 0; first < waiting.Count; first += 8) CoverSmall(ref Unsafe.Add(ref waiting.Triangle, first), SetUp(waiting, first));
        waiting.Clear();
        if (queue.Count > QueueLength) Decide();
    }

    private void AddLarge()
    {
        for (var first = 0; first < waitingLarge.Count; first += 8)
        {
            for (var shows = SetUp(waitingLarge, first); shows != 0; shows &= shows - 1)
            {
                var i = BitOperations.TrailingZeroCount(shows);
                Cover(Unsafe.Add(ref waitingLarge.Triangle, first + i), i);
            }
        }
        waitingLarge.Clear();
        if (queue.Count > QueueLength) Decide();
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
        ref var coveredAt = ref MemoryMarshal.GetArrayDataReference(covered);
        ref var frontAt = ref MemoryMarshal.GetArrayDataReference(front);
        ref var proposedAt = ref MemoryMarshal.GetArrayDataReference(proposed);
        ref var pixels = ref MemoryMarshal.GetArrayDataReference(pixelOfLane);
        ref var uppers = ref MemoryMarshal.GetArrayDataReference(upperOfLane);
        ref var lowers = ref MemoryMarshal.GetArrayDataReference(lowerOfLane);
        var (left, bottom) = (Field(ref s, TriangleSetUp.Left), Field(ref s, TriangleSetUp.Bottom));
        var (across, upwards) = (Field(ref s, TriangleSetUp.Right) - left, Field(ref s, TriangleSetUp.Top) - bottom);
        var firstPixel = Vector256.ConvertToInt32Native(bottom * Vector256.Create((float)Stride) + left);
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
                (firstPixel + Vector256.Create(y * Stride + x)).StoreUnsafe(ref pixels);
                for (; bits != 0; bits &= bits - 1)
                {
                    var i = BitOperations.TrailingZeroCount(bits);
                    var (pixel, mostW, leastW) = (Unsafe.Add(ref pixels, i), Unsafe.Add(ref uppers, i), Unsafe.Add(ref lowers, i));
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
                        Enqueue(pixel, Unsafe.Add(ref triangle, i), mostW);
                    }
                    if (leastW > sure) sure = leastW;
                }
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<float> Field(ref float setup, int field) => Vector256.LoadUnsafe(ref Unsafe.Add(ref setup, 8 * field));

    [MethodImpl(MethodImplOptions.NoInlining)]
    private void Enqueue(int pixel, int triangle, float mostW)
    {
        if (!twins.HasEarlier(triangle)) queue.Add((pixel, triangle, mostW));
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
        ref var pixels = ref MemoryMarshal.GetArrayDataReference(unsurePixels);
        ref var unsureAt = ref MemoryMarshal.GetArrayDataReference(unsureLanes);
        var count = 0;

        ref var coveredAt = ref MemoryMarshal.GetArrayDataReference(covered);
        ref var frontAt = ref MemoryMarshal.GetArrayDataReference(front);
        ref var proposedAt = ref MemoryMarshal.GetArrayDataReference(proposed);
        for (var x = 0; x <= right - left; x += 8)
        {
            var across = lanes + Vector256.Create((float)x);
            var inBox = Vector256.LessThanOrEqual(across, Vector256.Create((float)(right - left)));
            var u = Vector256.Create(At(ref s, TriangleSetUp.U)) + across * At(ref s, TriangleSetUp.U + 1);
            var v = Vector256.Create(At(ref s, TriangleSetUp.V)) + across * At(ref s, TriangleSetUp.V + 1);
            var w = Vector256.Create(At(ref s, TriangleSetUp.W)) + across * At(ref s, TriangleSetUp.W + 1);
            var depth = Vector256.Create(At(ref s, TriangleSetUp.Depth)) + across * At(ref s, TriangleSetUp.Depth + 1);
            var pixel = bottom * Stride + left + x;
            for (var y = 0; y <= top - bottom; y++, pixel += Stride)
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
                (Unsafe.Add(ref unsureAt, count), Unsafe.Add(ref pixels, count)) = (unsure, pixel);
                count++;
            }
        }
        if (count > 0) Enqueue(count, triangle);
    }

    /// <summary>Puts a triangle's pixels that are not sure into the queue.</summary>
    private void Enqueue(int count, int triangle)
    {
        if (twins.HasEarlier(triangle)) return;
        for (var k = 0; k < count; k++)
        {
            for (var lanes = unsureLanes[k]; lanes != 0; lanes &= lanes - 1)
            {
                var i = BitOperations.TrailingZeroCount(lanes);
                queue.Add((unsurePixels[k] + i, triangle, unsureUppers[8 * k + i]));
            }
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
            exact.Add(tile.Column + pixel % Stride, tile.Row + pixel / Stride, triangle, pixel, decided, covered);
        }
        exact.Flush(decided, covered);
        queue.Clear();
    }
}
