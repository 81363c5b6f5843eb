using System.Runtime.CompilerServices;

namespace RayCaster.Engine;

/// <summary>Brings a mesh whose triangles come in random order, as a scanner's do, into an order in space: then triangles that follow one another lie
/// side by side in space and in memory, as the engine expects.</summary>
public sealed class SpatialOrder
{
    /// <summary>A mesh with fewer triangles lies in the processor's caches.</summary>
    private const int FewTriangles = 1 << 17;

    /// <summary>An order is random if in some pairs of consecutive triangles one is on average many of its sizes away from the other.</summary>
    private const int Pairs = 256, ManySizes = 16;

    /// <summary>The bits of a cell's place along each axis: the surface of a million triangles has some ten in a cell.</summary>
    private const int Bits = 7;

    /// <summary>Each thread counts for itself, in eight megabytes or four bytes a vertex.</summary>
    private const int MostThreads = 8;

    private readonly Vector3[] old, vertices;
    private readonly int[] oldIndices, indices, places; // the places first hold each vertex's cell, then its new index
    private readonly Vector3 low;
    private readonly double perUnit;

    private SpatialOrder(Mesh mesh, int threads)
    {
        (old, oldIndices) = (mesh.Vertices, mesh.Indices);
        (vertices, places) = (GC.AllocateUninitializedArray<Vector3>(old.Length), GC.AllocateUninitializedArray<int>(old.Length));
        indices = GC.AllocateUninitializedArray<int>(oldIndices.Length);
        var bounds = TriangleBoxes.SampleBounds(old);
        var size = bounds.Max - bounds.Min;
        (low, perUnit) = (bounds.Min, ((1 << Bits) - 1) / Math.Max(size.X, Math.Max(size.Y, size.Z)));
        Sort(1 << (3 * Bits), old.Length, CountVertices, PutVertices);
        Sort(old.Length, mesh.TriangleCount, CountTriangles, PutTriangles);

        void Sort(int keys, int count, Action<int, int, int[]> add, Action<int, int, int[]> put)
        {
            var shares = Math.Min(threads, MostThreads);
            CountingSort.Sort(
                shares, keys, (i, counts) => add(Start(i), Start(i + 1), counts), (i, next) => put(Start(i), Start(i + 1), next));

            int Start(int share) => (int)((long)count * share / shares);
        }
    }

    /// <summary>The same scene with other meshes in place of those in random order: every pixel shows the same model at the same t, but a
    /// triangle's number is no longer that in the file.</summary>
    /// <remarks>It takes as long as drawing the new mesh once, and as much memory again as the old one has until that is freed.</remarks>
    public static Scene Of(Scene scene, int? threads = null)
    {
        if (!scene.Models.Any(IsRandom)) return scene;
        var models = scene.Models.ToArray();
        for (var i = 0; i < models.Length; i++)
        {
            if (!IsRandom(models[i])) continue;
            var order = new SpatialOrder((Mesh)models[i], threads ?? Environment.ProcessorCount);
            models[i] = new Mesh(order.vertices, order.indices) { Name = models[i].Name, Color = models[i].Color };
        }
        return scene with { Models = models };
    }

    private static bool IsRandom(Model model)
    {
        if (model is not Mesh { TriangleCount: >= FewTriangles } mesh) return false;
        var (away, size) = (0.0, 0.0);
        for (var i = 1; i < mesh.TriangleCount; i += mesh.TriangleCount / Pairs)
            (away, size) = (away + (mesh[i].A - mesh[i - 1].A).Length, size + (mesh[i].B - mesh[i].A).Length);
        return away > ManySizes * size;
    }

    /// <summary>The cell of a point by its place on a curve through all cells: the bits of its three coordinates in turn, as a Gray code, which
    /// jumps less than the plain number (Faloutsos, "Gray codes for partial match and range queries", 1988).</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private int CellOf(in Vector3 p)
    {
        var code = Spread((p.X - low.X) * perUnit) << 2 | Spread((p.Y - low.Y) * perUnit) << 1 | Spread((p.Z - low.Z) * perUnit);
        for (var shift = 1; shift < 3 * Bits; shift *= 2) code ^= code >> shift;
        return code;

        static int Spread(double place) // two zeros after each bit; NaN becomes 0
        {
            var bits = Math.Clamp((int)place, 0, (1 << Bits) - 1);
            bits = (bits | bits << 8) & 0x00700F;
            bits = (bits | bits << 4) & 0x0430C3;
            return (bits | bits << 2) & 0x049249;
        }
    }

    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private void CountVertices(int first, int end, int[] counts)
    {
        for (var i = first; i < end; i++) counts[places[i] = CellOf(old[i])]++;
    }

    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private void PutVertices(int first, int end, int[] next)
    {
        for (var i = first; i < end; i++) vertices[places[i] = next[places[i]]++] = old[i];
    }

    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private void CountTriangles(int first, int end, int[] counts)
    {
        for (var i = first; i < end; i++) counts[places[oldIndices[3 * i]]]++;
    }

    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
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
