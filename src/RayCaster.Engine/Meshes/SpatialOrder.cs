namespace RayCaster.Engine;

/// <summary>
/// Brings a mesh whose triangles come in random order, as a scanner's do, into an order in space: then triangles that follow one another
/// lie side by side in space and in memory, and are drawn in half of the time.
/// </summary>
internal static class SpatialOrder
{
    /// <summary>A mesh with fewer triangles lies in the processor's caches, so its order hardly matters.</summary>
    internal const int FewTriangles = 1 << 17;

    /// <summary>A sample of pairs of consecutive triangles shows the order. It is random if they are on average farther apart than this multiple
    /// of their size.</summary>
    private const int Pairs = 256, FarApart = 16;

    /// <summary>The bits of a cell's number along each axis: of a surface of a million triangles, a cell holds some ten.</summary>
    private const int Bits = 7;

    private static readonly ConditionalWeakTable<Mesh, Mesh> kept = [];

    /// <summary>A mesh of the same triangles, of which each pixel shows the same t; the mesh itself if its order is not random. It stays in
    /// memory as long as the mesh does.</summary>
    public static Mesh Of(Mesh mesh) =>
        mesh.TriangleCount < FewTriangles ? mesh : kept.GetValue(mesh, static mesh => IsRandom(mesh) ? Sorted(mesh) : mesh);

    private static bool IsRandom(Mesh mesh)
    {
        var (apart, size) = (0.0, 0.0);
        for (var i = 1; i < mesh.TriangleCount; i += mesh.TriangleCount / Pairs)
            (apart, size) = (apart + (mesh[i].A - mesh[i - 1].A).Length, size + (mesh[i].B - mesh[i].A).Length);
        return apart > FarApart * size;
    }

    /// <summary>Sorts the vertices by their cells, and the triangles by their first corners.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static Mesh Sorted(Mesh mesh)
    {
        var (low, perUnit) = Grid(mesh.Vertices);
        var vertexOrder = Order(Array.ConvertAll(mesh.Vertices, p => CellOf(perUnit * (p - low))), 1 << (3 * Bits));
        var vertices = new Vector3[mesh.Vertices.Length];
        for (var i = 0; i < vertices.Length; i++) vertices[vertexOrder[i]] = mesh.Vertices[i];

        var corners = Array.ConvertAll(mesh.Indices, vertex => vertexOrder[vertex]);
        var firstCorners = new int[mesh.TriangleCount];
        for (var i = 0; i < firstCorners.Length; i++) firstCorners[i] = corners[3 * i];
        var triangleOrder = Order(firstCorners, vertices.Length);
        var indices = new int[corners.Length];
        for (var i = 0; i < triangleOrder.Length; i++) corners.AsSpan(3 * i, 3).CopyTo(indices.AsSpan(3 * triangleOrder[i]));
        return new(vertices, indices);
    }

    /// <summary>Where the grid of cells begins, and how many cells there are in a unit of length.</summary>
    private static (Vector3 Low, double PerUnit) Grid(Vector3[] vertices)
    {
        var bounds = Bounds.Empty; // of some: what lies outside belongs to the cell next to it
        for (var i = 0; i < vertices.Length; i += vertices.Length / 1024 + 1) bounds = bounds.With(vertices[i]);
        var size = bounds.Max - bounds.Min;
        return (bounds.Min, ((1 << Bits) - 1) / Math.Max(size.X, Math.Max(size.Y, size.Z)));
    }

    /// <summary>The new position of each item when they are sorted by a number from 0 to <paramref name="numbers"/> − 1; those of the same number
    /// keep their order.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static int[] Order(int[] numberOf, int numbers)
    {
        var next = new int[numbers + 1];
        foreach (var number in numberOf) next[number + 1]++;
        for (var number = 0; number < numbers; number++) next[number + 1] += next[number];
        return Array.ConvertAll(numberOf, number => next[number]++);
    }

    /// <summary>The number of a cell along a curve through all cells. Its bits are those of the three coordinates in turn, as a Gray code:
    /// neighbours on the curve are then less far apart than without it (Faloutsos, "Gray codes for partial match and range queries",
    /// 1988).</summary>
    private static int CellOf(Vector3 p)
    {
        var code = Spread(p.X) << 2 | Spread(p.Y) << 1 | Spread(p.Z);
        for (var shift = 1; shift < 3 * Bits; shift *= 2) code ^= code >> shift;
        return code;

        static int Spread(double coordinate) // two zeros between its bits
        {
            var bits = Math.Clamp((int)coordinate, 0, (1 << Bits) - 1);
            bits = (bits | bits << 8) & 0x00700F;
            bits = (bits | bits << 4) & 0x0430C3;
            return (bits | bits << 2) & 0x049249;
        }
    }
}
