namespace RayCaster.Engine;

/// <summary>One thread's tool for one tile after another: finds for each pixel the triangle that may be in front there. What is surely hidden is
/// left out, group by group, then triangles that cover no sample, eight at once.</summary>
internal sealed class TileFilter<N> where N : struct, IPacket<N>
{
    /// <summary>After this many runs or triangles the coarse depth is computed again.</summary>
    private const int RunsAtOnce = 128, TrianglesAtOnce = 512;

    private const int Ahead = 16;

    private readonly ScreenSpace screen;
    private readonly TilePixels pixels = new();
    private readonly TileHits<N> hits;
    private readonly TriangleRasterizer rasterizer;
    private readonly CoarseDepth coarse = new();
    private readonly PooledList<TriangleCluster> large = new();
    private readonly TriangleQueue waiting = new(), waitingLarge = new();
    private EightTriangles eight;
    private PixelRect tile;
    private bool isEmpty;

    public TileFilter(ScreenSpace screen)
    {
        this.screen = screen;
        hits = new(screen, pixels);
        rasterizer = new(screen, pixels, hits.Decide);
    }

    /// <summary>Sets the tile and the mesh; returns where its hits lie.</summary>
    public HitRange Begin(in PixelRect tile, Vector3[] vertices, int[] indices, ScreenTriangles<N>[] sets)
    {
        this.tile = tile;
        pixels.SetMesh(vertices, indices);
        hits.SetMesh(vertices, indices);
        isEmpty = true;
        foreach (var set in sets)
        {
            set.FindLarge(tile, large);
            Add(set, large.Items);
            Add(set, set.Of(tile));
        }
        if (isEmpty) return HitRange.None;
        hits.Decide();
        coarse.Update(pixels.OccluderInverseDepth);
        var least = coarse.Least;
        return new(
            screen.ReferenceDepth / rasterizer.MaxInverseDepth * (1 - 1e-6),
            least > 0 ? screen.ReferenceDepth / least * screen.LongestT * (1 + 1e-6) : double.PositiveInfinity);
    }

    /// <inheritdoc cref="TileHits{N}.Intersect"/>
    public void Intersect(RayStream rays, int index) => hits.Intersect(rays, index);

    /// <inheritdoc cref="TileHits{N}.Paint"/>
    public void Paint(MeshPainter painter, byte[] rgb, int first, int step) => hits.Paint(painter, rgb, first, step);

    /// <summary>Triangles of at least this inverse depth count as near. It is 0.7 of the way from the least to the greatest inverse depth of a
    /// sample of them. With more, too few are near to hide the others; with less, too many are drawn before anything is hidden.</summary>
    private static float MinOfNear(ReadOnlySpan<TriangleCluster> all)
    {
        const int Samples = 16;
        var (least, most) = (float.PositiveInfinity, 0f);
        for (var i = 0; i < all.Length; i += all.Length / Samples + 1)
            (least, most) = (Math.Min(least, all[i].MaxInverseDepth), Math.Max(most, all[i].MaxInverseDepth));
        return 0.3f * least + 0.7f * most;
    }

    /// <summary>Prepares for a tile in which triangles may show; everything stored so far is about another tile.</summary>
    private void Clear()
    {
        isEmpty = false;
        coarse.Clear();
        pixels.Begin(tile);
        rasterizer.Begin(tile);
    }

    /// <summary>Adds what is not hidden, near triangles first: most of the others are then found to be hidden.</summary>
    private void Add(ScreenTriangles<N> set, ReadOnlySpan<TriangleCluster> all)
    {
        if (all.Length == 0) return;
        if (isEmpty) Clear();
        var minOfNear = MinOfNear(all);
        Add(set, all, minOfNear, nearPass: true);
        Refresh();
        Add(set, all, minOfNear, nearPass: false);
    }

    /// <summary>Adds what is not hidden of near triangles, or of the others.</summary>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private void Add(ScreenTriangles<N> set, ReadOnlySpan<TriangleCluster> all, float minOfNear, bool nearPass)
    {
        var firstRow = tile.Row % Tile.MaxSide;
        Span<TriangleRun> seen = stackalloc TriangleRun[RunsAtOnce];
        for (var next = 0; next < all.Length;)
        {
            var (count, triangles) = (0, 0);
            for (; next < all.Length && count < seen.Length && triangles < TrianglesAtOnce; next++)
            {
                var isNear = all[next].MaxInverseDepth >= minOfNear;
                if (isNear != nearPass || coarse.Hides(all[next].Cells, firstRow, all[next].MaxInverseDepth)) continue;
                seen[count++] = all[next].Run;
                triangles += all[next].Run.Count;
            }
            AddRuns(set, seen[..count]);
            if (next < all.Length) Refresh();
        }
        AddWaiting();
    }

    /// <remarks>Indices and vertices are prefetched: they lie anywhere in memory, and waiting for them would take longer than the rest.</remarks>
    private void AddRuns(ScreenTriangles<N> set, ReadOnlySpan<TriangleRun> runs)
    {
        var corners = set.Corners;
        var last = Vector128.Create(set.Corners.Count - 1);
        Span<int> ids = stackalloc int[12];
        var count = 0;
        for (var i = -Ahead; i < runs.Length; i++)
        {
            if (i + Ahead < runs.Length) corners.Prefetch(runs[i + Ahead].First, runs[i + Ahead].Count);
            if (i + Ahead / 2 is >= 0 and var near && near < runs.Length) corners.PrefetchVertices(runs[near].First, runs[near].Count);
            if (i < 0) continue;
            var end = Math.Min(runs[i].First + runs[i].Count, corners.Count);
            for (var first = runs[i].First; first < end; first += 4)
            {
                Vector128.Min(Vector128.Create(first) + Vector128<int>.Indices, last).CopyTo(ids[count..]);
                count += Math.Min(4, end - first);
                if (count < 8) continue;
                AddEight(ids, 8);
                ids[8..].CopyTo(ids);
                count -= 8;
            }
        }
        if (count > 0) AddEight(ids, count);

        void AddEight(ReadOnlySpan<int> ids, int count)
        {
            corners.Project(ids[..8], out eight);
            Add(set, Vector256.Create(ids), count);
        }
    }

    /// <summary>Takes the eight triangles that are seen, or less: those in whose boxes are samples wait.</summary>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private void Add(ScreenTriangles<N> set, Vector256<int> ids, int count)
    {
        ref readonly var t = ref eight;
        var margin = Vector256.Create(screen.Margin);
        var (column, row) = (Vector256.Create((float)tile.Column), Vector256.Create((float)tile.Row));
        var (minX, maxX) = (Lanes.MinOrLast(t.A.X, t.B.X, t.C.X), Lanes.MaxOrLast(t.A.X, t.B.X, t.C.X));
        var (minY, maxY) = (Lanes.MinOrLast(t.A.Y, t.B.Y, t.C.Y), Lanes.MaxOrLast(t.A.Y, t.B.Y, t.C.Y));
        var left = Lanes.MaxOrLast(Vector256.Ceiling(minX - margin), column);
        var right = Lanes.MinOrLast(Vector256.Floor(maxX + margin), column + Vector256.Create(tile.Width - 1f));
        var bottom = Lanes.MaxOrLast(Vector256.Ceiling(minY - margin), row);
        var top = Lanes.MinOrLast(Vector256.Floor(maxY + margin), row + Vector256.Create(tile.Height - 1f));
        var shows = (Vector256.LessThanOrEqual(left, right) & Vector256.LessThanOrEqual(bottom, top)).ExtractMostSignificantBits();
        if (count < 8) shows &= (1u << count) - 1;
        if (shows == 0) return;
        if (set.Owners is { } owners)
            for (var i = 0; i < 8; i++)
                ids = ids.WithElement(i, owners[Math.Min(ids[i], owners.Length - 1)]);

        var side = Vector256.Create((float)TriangleRasterizer.SmallSide);
        var small = (Vector256.LessThan(right - left, side) & Vector256.LessThan(top - bottom, side)).ExtractMostSignificantBits();
        if ((shows & small) != 0)
        {
            waiting.Add(t, ids, shows & small);
            if (waiting.IsFull) rasterizer.AddSmall(waiting);
        }
        var large = shows & ~small;
        if (large != 0)
        {
            waitingLarge.Add(t, ids, large);
            if (waitingLarge.IsFull) rasterizer.AddLarge(waitingLarge);
        }
    }

    /// <summary>Rasterizes the waiting triangles and computes the coarse depth again.</summary>
    private void Refresh()
    {
        AddWaiting();
        hits.Decide(); // one pixel that is not sure to be covered would let through all that may lie in its cell
        coarse.Update(pixels.OccluderInverseDepth);
    }

    private void AddWaiting()
    {
        rasterizer.AddSmall(waiting);
        rasterizer.AddLarge(waitingLarge);
    }
}
