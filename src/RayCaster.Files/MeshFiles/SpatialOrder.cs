namespace RayCaster.Files;

/// <summary>
/// Brings a mesh whose triangles come in random order, as a scanner's do, into an order in space: then triangles that follow one another
/// lie side by side in space and in memory, and are drawn in half of the time.
/// </summary>
public sealed class SpatialOrder
{
    /// <summary>A mesh with fewer triangles lies in the processor's caches, so its order hardly matters.</summary>
    private const int FewTriangles = 1 << 17;

    /// <summary>A sample of pairs of consecutive triangles shows the order. It is random if they are on average farther apart than this multiple
    /// of their size.</summary>
    private const int Pairs = 256, FarApart = 16;

    /// <summary>The bits of a cell's place along each axis: of a surface of a million triangles, a cell holds some ten.</summary>
    private const int Bits = 7;

    /// <summary>Each thread counts by itself, in 4 bytes for each cell, then for each vertex.</summary>
    private const int MostThreads = 8;

    private readonly Vector3[] old, vertices;
    private readonly int[] oldIndices, indices, places; // a vertex's place is its cell's at first, then its own
    private readonly Vector3 low;
    private readonly double perUnit;

    private SpatialOrder(Mesh mesh, int threads)
    {
        (old, oldIndices) = (mesh.Vertices, mesh.Indices);
        (vertices, places) = (GC.AllocateUninitializedArray<Vector3>(old.Length), GC.AllocateUninitializedArray<int>(old.Length));
        indices = GC.AllocateUninitializedArray<int>(oldIndices.Length);
        var bounds = Bounds.Empty; // of some: what lies outside belongs to the cell next to it
        for (var i = 0; i < old.Length; i += old.Length / 1024 + 1) bounds = bounds.With(old[i]);
        var size = bounds.Max - bounds.Min;
        (low, perUnit) = (bounds.Min, ((1 << Bits) - 1) / Math.Max(size.X, Math.Max(size.Y, size.Z)));

        var shares = Math.Min(threads, MostThreads);
        Sort(shares, 1 << (3 * Bits), old.Length, CountVertices, PutVertices);
        Sort(shares, old.Length, mesh.TriangleCount, CountTriangles, PutTriangles);
    }

    /// <summary>The scene with new meshes in place of those in random order: each pixel shows the same model at the same t, but a triangle of such a
    /// mesh has another number than in the file.</summary>
    /// <param name="threads">How many threads sort; one per core if left out. The order does not depend on it.</param>
    /// <remarks>It takes about as long as drawing the new mesh once, and as much memory again as the old one until that is freed.</remarks>
    public static Scene Of(Scene scene, int? threads = null)
    {
        if (!scene.Models.Any(IsRandom)) return scene;
        return scene with { Models = [.. scene.Models.Select(model => IsRandom(model) ? Sorted((Mesh)model, threads) : model)] };
    }

    private static bool IsRandom(Model model)
    {
        if (model is not Mesh { TriangleCount: >= FewTriangles } mesh) return false;
        var (apart, size) = (0.0, 0.0);
        for (var i = 1; i < mesh.TriangleCount; i += mesh.TriangleCount / Pairs)
            (apart, size) = (apart + (mesh[i].A - mesh[i - 1].A).Length, size + (mesh[i].B - mesh[i].A).Length);
        return apart > FarApart * size;
    }

    private static Mesh Sorted(Mesh mesh, int? threads)
    {
        var order = new SpatialOrder(mesh, threads ?? Environment.ProcessorCount);
        return new(order.vertices, order.indices) { Name = mesh.Name, Color = mesh.Color };
    }

    /// <summary>Sorts items by a small number; those of the same number keep their order.</summary>
    /// <param name="count">Counts the items of a range by their numbers.</param>
    /// <param name="put">Puts the items of a range where they belong: it gets each number's next position, and moves it on.</param>
    private static void Sort(int shares, int numbers, int items, Action<int, int, int[]> count, Action<int, int, int[]> put)
    {
        var next = new int[shares][];
        Ranges.EachPiece(shares, shares, i => count(Start(i), Start(i + 1), next[i] = new int[numbers]));
        var sum = 0;
        for (var number = 0; number < numbers; number++)
            foreach (var positions in next)
                (positions[number], sum) = (sum, sum + positions[number]);
        Ranges.EachPiece(shares, shares, i => put(Start(i), Start(i + 1), next[i]));

        int Start(int share) => (int)((long)items * share / shares);
    }

    /// <summary>The place of a point's cell on a curve through all cells. Its bits are those of the three coordinates in turn, as a Gray code:
    /// neighbours on the curve are then less far apart than without it (Faloutsos, "Gray codes for partial match and range queries",
    /// 1988).</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private int CellOf(Vector3 p)
    {
        var code = Spread((p.X - low.X) * perUnit) << 2 | Spread((p.Y - low.Y) * perUnit) << 1 | Spread((p.Z - low.Z) * perUnit);
        for (var shift = 1; shift < 3 * Bits; shift *= 2) code ^= code >> shift;
        return code;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static int Spread(double place) // two zeros between its bits
        {
            var bits = Math.Clamp((int)place, 0, (1 << Bits) - 1);
            bits = (bits | bits << 8) & 0x00700F;
            bits = (bits | bits << 4) & 0x0430C3;
            return (bits | bits << 2) & 0x049249;
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void CountVertices(int first, int end, int[] counts)
    {
        for (var i = first; i < end; i++) counts[places[i] = CellOf(old[i])]++;
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void PutVertices(int first, int end, int[] next)
    {
        for (var i = first; i < end; i++) vertices[places[i] = next[places[i]]++] = old[i];
    }

    /// <remarks>A triangle's number is the place of its first corner.</remarks>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void CountTriangles(int first, int end, int[] counts)
    {
        for (var i = first; i < end; i++) counts[places[oldIndices[3 * i]]]++;
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void PutTriangles(int first, int end, int[] next)
    {
        for (var i = first; i < end; i++)
        {
            var (a, b, c) = (places[oldIndices[3 * i]], places[oldIndices[3 * i + 1]], places[oldIndices[3 * i + 2]]);
            var to = 3 * next[a]++;
            (indices[to], indices[to + 1], indices[to + 2]) = (a, b, c);
        }
    }
}
