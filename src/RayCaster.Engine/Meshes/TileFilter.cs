using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace RayCaster.Engine;

/// <summary>One thread's tool for one tile after another: finds for each pixel the triangle that may be in front there. What is surely hidden is
/// left out, group by group, then triangles that cover no sample, eight at once.</summary>
internal sealed class TileFilter<N> where N : struct, IPacket<N>
{
    /// <summary>After so many clusters or triangles it is found out anew what is hidden.</summary>
    private const int ClustersAtOnce = 32, TrianglesAtOnce = 128;

    /// <summary>How many clusters ahead memory is fetched.</summary>
    private const int Ahead = 4;

    /// <summary>How many single triangles ahead.</summary>
    private const int VerticesAhead = 24, IndicesAhead = 64;

    private readonly ScreenSpace screen;
    private readonly TilePixels pixels = new();
    private readonly TileHits<N> hits;
    private readonly TriangleRasterizer cover;
    private readonly CoarseDepth coarse = new();
    private readonly TriangleQueue waiting = new(), waitingLarge = new();
    private EightTriangles eight;
    private Tile tile;
    private bool isEmpty;

    public TileFilter(ScreenSpace screen)
    {
        this.screen = screen;
        hits = new(screen, pixels);
        cover = new(screen, pixels, coarse, hits.Decide);
    }

    /// <summary>The view whose pixels it knows; null where it knows none.</summary>
    public MeshView<N>? Owner { get; private set; }

    public Tile Tile => tile;

    /// <summary>Goes to another mesh.</summary>
    /// <param name="owner">The view that uses it from now on.</param>
    public void Show(MeshView<N> owner, Vector3[] vertices, int[] indices)
    {
        Owner = owner;
        pixels.Show(vertices, indices);
        hits.Show(vertices, indices);
    }

    public HitRange Enter(in Tile tile, ScreenTriangles<N>[] sets)
    {
        this.tile = tile;
        isEmpty = true;
        foreach (var set in sets)
        {
            // Most of what is seen of a closed mesh faces the camera with the same side; that side first, most of the other is found to be hidden.
            for (var large = CollectionsMarshal.AsSpan(set.Large); large.Length > 0; large = large[Math.Min(TrianglesAtOnce, large.Length)..])
            {
                AddTriangles(set, large[..Math.Min(TrianglesAtOnce, large.Length)]);
                Refresh();
            }
            var nearer = MeanW(set, tile, 0) < MeanW(set, tile, 1) ? 1 : 0;
            Add(set, set.ClustersOf(tile, nearer), areClusters: true);
            Add(set, set.Of(tile, nearer), areClusters: false);
            if (!isEmpty) Refresh();
            Add(set, set.ClustersOf(tile, 1 - nearer), areClusters: true);
            Add(set, set.Of(tile, 1 - nearer), areClusters: false);
        }
        if (isEmpty)
        {
            Owner = null; // nothing is known that the view could need
            return HitRange.None;
        }
        hits.Decide();
        coarse.Update(pixels.Covered);
        var least = coarse.Least;
        return new(
            screen.Unit / cover.GreatestW * (1 - 1e-6),
            least > 0 ? screen.Unit / least * screen.LongestT * (1 + 1e-6) : double.PositiveInfinity);
    }

    /// <summary>Keeps the mesh's hits for some pixels of a row.</summary>
    public void Meet(RayStream rays, int index) => hits.Meet(rays, index);

    /// <inheritdoc cref="TileHits{N}.Paint"/>
    public void Paint(MeshPainter painter, byte[] rgb, int first, int step) => hits.Paint(painter, rgb, first, step);

    private static float MeanW(ScreenTriangles<N> set, in Tile tile, int side)
    {
        const int Samples = 8;
        var some = set.ClustersOf(tile, side) is { Length: > 0 } clusters ? clusters : set.Of(tile, side);
        if (some.Length == 0) return 0;
        var (sum, step) = (0f, (some.Length + Samples - 1) / Samples);
        for (var i = 0; i < some.Length; i += step) sum += some[i].MostW;
        return sum / ((some.Length + step - 1) / step);
    }

    /// <summary>Comes to a tile in which there may be something; all that is known is of another one.</summary>
    private void Begin()
    {
        isEmpty = false;
        coarse.Clear();
        pixels.Enter(tile);
        cover.Enter(tile);
    }

    /// <summary>Adds what is not hidden.</summary>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private void Add(ScreenTriangles<N> set, ReadOnlySpan<TriangleCluster> all, bool areClusters)
    {
        if (all.Length == 0) return;
        if (isEmpty) Begin();
        var firstRow = tile.Row % Tile.MaxSide;
        Span<int> seen = stackalloc int[TrianglesAtOnce];
        if (areClusters) seen = seen[..ClustersAtOnce];
        for (var next = 0; next < all.Length;)
        {
            var count = 0;
            for (; next < all.Length && count < seen.Length; next++)
                if (!coarse.Hides(all[next].Cells, firstRow, all[next].MostW))
                    seen[count++] = all[next].First;
            if (areClusters) AddClusters(set, seen[..count]);
            else AddTriangles(set, seen[..count]);
            if (next < all.Length) Refresh();
        }
        AddWaiting();
    }

    /// <remarks>Their indices and vertices lie anywhere; to wait for them would take longer than all that is computed.</remarks>
    private void AddClusters(ScreenTriangles<N> set, ReadOnlySpan<int> clusters)
    {
        for (var i = -Ahead; i < clusters.Length; i++)
        {
            if (i + Ahead < clusters.Length) set.Corners.Fetch(clusters[i + Ahead]);
            if (i + Ahead / 2 is >= 0 and var near && near < clusters.Length) set.Corners.FetchVertices(clusters[near]);
            if (i < 0) continue;
            var end = Math.Min(clusters[i] + TriangleCluster.Length, set.Corners.Count);
            for (var first = clusters[i]; first < end; first += 8)
            {
                set.Corners.SeeRun(first, out eight);
                Add(set, Vector256.Create(first) + Vector256<int>.Indices, end - first);
            }
        }
    }

    private void AddTriangles(ScreenTriangles<N> set, ReadOnlySpan<int> triangles)
    {
        if (isEmpty) Begin();
        Span<int> ids = stackalloc int[8];
        set.Corners.Fetch(triangles[..Math.Min(IndicesAhead, triangles.Length)]);
        for (var first = 0; first < triangles.Length; first += 8)
        {
            if (first + IndicesAhead + 8 <= triangles.Length) set.Corners.Fetch(triangles.Slice(first + IndicesAhead, 8));
            if (first + VerticesAhead + 8 <= triangles.Length) set.Corners.FetchVertices(triangles.Slice(first + VerticesAhead, 8));
            for (var i = 0; i < 8; i++) ids[i] = triangles[Math.Min(first + i, triangles.Length - 1)];
            set.Corners.See(ids, out eight);
            Add(set, Vector256.Create<int>(ids), triangles.Length - first);
        }
    }

    /// <summary>Takes the eight triangles that are seen, or less: those in whose boxes are samples wait.</summary>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private void Add(ScreenTriangles<N> set, Vector256<int> names, int count)
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

        var side = Vector256.Create((float)TriangleRasterizer.SmallSide);
        var small = (Vector256.LessThan(right - left, side) & Vector256.LessThan(top - bottom, side)).ExtractMostSignificantBits();
        if ((shows & small) != 0)
        {
            waiting.Add(t, names, shows & small);
            if (waiting.IsFull) cover.AddSmall(waiting);
        }
        var large = shows & ~small;
        if (large != 0)
        {
            waitingLarge.Add(t, names, large);
            if (waitingLarge.IsFull) cover.AddLarge(waitingLarge);
        }
    }

    /// <summary>Draws what waits, and finds out anew what is hidden.</summary>
    private void Refresh()
    {
        AddWaiting();
        hits.Decide(); // one pixel that is not sure to be covered would let through all that may lie in its cell
        coarse.Update(pixels.Covered);
    }

    private void AddWaiting()
    {
        cover.AddSmall(waiting);
        cover.AddLarge(waitingLarge);
    }
}
