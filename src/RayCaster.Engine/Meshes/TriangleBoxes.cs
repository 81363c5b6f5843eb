namespace RayCaster.Engine;

/// <summary>What depends only on a mesh: a box around each cluster of consecutive triangles.</summary>
/// <remarks>The numbers are floats relative to a point and a length of the mesh, so they suit a scene of any size. They take 1.5 bytes for each
/// triangle; a mesh whose triangles share their corners takes 24.</remarks>
internal sealed class TriangleBoxes
{
    /// <summary>The number of triangles in a cluster; less at the mesh's end.</summary>
    public const int ClusterLength = 16;

    private const int ClustersAtOnce = 1 << 10;

    /// <summary>How many triangles ahead memory is fetched: waiting for it would take longer than finding the boxes. Vertices are fetched later than
    /// indices, which must be there first.</summary>
    private const int VerticesAhead = 6 * ClusterLength, IndicesAhead = 24 * ClusterLength;

    private static readonly ConditionalWeakTable<Mesh, TriangleBoxes> kept = [];

    private readonly Vector3[] vertices;
    private readonly int[] indices;
    private readonly Vector256<double> middle, perUnit;
    private readonly float[][] numbers = new float[6][]; // lows and highs
    private Vector256<double> least = Vector256.Create(double.PositiveInfinity), most = Vector256.Create(double.NegativeInfinity); // of all

    /// <param name="indices">Three for each triangle. Each of them is checked here, once for all.</param>
    public TriangleBoxes(Vector3[] vertices, int[] indices, int threads, CancellationToken cancellation = default)
    {
        (this.vertices, this.indices) = (vertices, indices);
        Count = (indices.Length / 3 + ClusterLength - 1) / ClusterLength;
        var bounds = Bounds.Empty;
        for (var i = 0; i < vertices.Length; i += vertices.Length / 1024 + 1)
            if (double.IsFinite(vertices[i].X + vertices[i].Y + vertices[i].Z))
                bounds = bounds.With(vertices[i]);
        Middle = 0.5 * (bounds.Min + bounds.Max);
        var size = bounds.Max - bounds.Min;
        Extent = Math.Max(size.X, Math.Max(size.Y, size.Z));
        if (!(Extent > 0)) Extent = 1;
        (middle, perUnit) = (Vector256.Create(Middle.X, Middle.Y, Middle.Z, 0), Vector256.Create(1 / Extent));
        for (var i = 0; i < numbers.Length; i++) numbers[i] = GC.AllocateUninitializedArray<float>(Count + 7); // room for a packet at the end
        ThreadTeam.Each((Count + ClustersAtOnce - 1) / ClustersAtOnce, threads, piece =>
        {
            cancellation.ThrowIfCancellationRequested();
            Find(piece * ClustersAtOnce, Math.Min((piece + 1) * ClustersAtOnce, Count));
        });
    }

    /// <summary>The point that is 0 in the boxes.</summary>
    public Vector3 Middle { get; }

    /// <summary>The length that is 1 in the boxes.</summary>
    public double Extent { get; }

    public Bounds Bounds => new(new(least[0], least[1], least[2]), new(most[0], most[1], most[2]));

    public int Count { get; }

    /// <summary>The boxes of a mesh, whose vertices and indices never change: they stay in memory as long as it does.</summary>
    public static TriangleBoxes Of(Mesh mesh, CancellationToken cancellation, int threads)
    {
        if (kept.TryGetValue(mesh, out var boxes)) return boxes;
        boxes = new(mesh.Vertices, mesh.Indices, threads, cancellation);
        kept.AddOrUpdate(mesh, boxes);
        return boxes;
    }

    public (int First, int End) TrianglesOf(int cluster)
    {
        var first = cluster * ClusterLength;
        return (first, Math.Min(first + ClusterLength, indices.Length / 3));
    }

    /// <summary>The least coordinates of several clusters, one in each lane. A corner that is NaN does not count, since it is part of no
    /// hit.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector3<N> Lows<N>(int first) where N : struct, IPacket<N> => Load<N>(0, first);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector3<N> Highs<N>(int first) where N : struct, IPacket<N> => Load<N>(3, first);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private Vector3<N> Load<N>(int kind, int first) where N : struct, IPacket<N> =>
        new(N.Load(numbers[kind], first), N.Load(numbers[kind + 1], first), N.Load(numbers[kind + 2], first));

    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private void Find(int cluster, int endCluster)
    {
        var (least, most) = (Vector256.Create(double.PositiveInfinity), Vector256.Create(double.NegativeInfinity));
        for (; cluster < endCluster; cluster++)
        {
            var (first, end) = TrianglesOf(cluster);
            var (low, high) = Around(first, end);
            (least, most) = (Lanes.MinOrLast(low, least), Lanes.MaxOrLast(high, most));
            (low, high) = ((low - middle) * perUnit, (high - middle) * perUnit);
            Set(0, cluster, low - Padding(low));
            Set(3, cluster, high + Padding(high));
        }
        lock (numbers) (this.least, this.most) = (Lanes.MinOrLast(least, this.least), Lanes.MaxOrLast(most, this.most));

        // Rounding to a float changes a number by at most 2⁻²⁴ of itself.
        static Vector256<double> Padding(Vector256<double> number) => Vector256.Create(1e-7) * (Vector256.Abs(number) + Vector256<double>.One);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Set(int kind, int cluster, Vector256<double> vector)
    {
        var floats = Vector128.Narrow(vector.GetLower(), vector.GetUpper());
        (numbers[kind][cluster], numbers[kind + 1][cluster], numbers[kind + 2][cluster]) = (floats[0], floats[1], floats[2]);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private Vector256<double> CornerAt(int index)
    {
        ref readonly var point = ref vertices[indices[index]];
        return Vector256.Create(point.X, point.Y, point.Z, 0);
    }

    /// <summary>The least and the greatest coordinates of some triangles; the fourth number is meaningless.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public (Vector256<double> Low, Vector256<double> High) Around(int first, int end)
    {
        if (end - first != ClusterLength || !AreBeforeTheLast(3 * first, 3 * end)) return AroundChecked(first, end);
        var vertexIndices = new RawSpan<int>(indices);
        var numbers = RawSpan.NumbersOf(vertices);
        if (first + IndicesAhead + ClusterLength <= indices.Length / 3) Prefetch(first);

        // Separate bounds for each corner, so that no comparison waits for the one before it.
        var none = Vector256.Create(double.PositiveInfinity);
        var (lowA, lowB, lowC) = (none, none, none);
        var (highA, highB, highC) = (-none, -none, -none);
        for (var i = 3 * first; i < 3 * end; i += 3)
        {
            // A vertex's three numbers and the next vertex's first.
            var (a, b) = (numbers.Load256((nint)3 * vertexIndices[i]), numbers.Load256((nint)3 * vertexIndices[i + 1]));
            var c = numbers.Load256((nint)3 * vertexIndices[i + 2]);
            (lowA, lowB, lowC) = (Lanes.MinOrLast(a, lowA), Lanes.MinOrLast(b, lowB), Lanes.MinOrLast(c, lowC));
            (highA, highB, highC) = (Lanes.MaxOrLast(a, highA), Lanes.MaxOrLast(b, highB), Lanes.MaxOrLast(c, highC));
        }
        return (Lanes.MinOrLast(Lanes.MinOrLast(lowA, lowB), lowC), Lanes.MaxOrLast(Lanes.MaxOrLast(highA, highB), highC));
    }

    /// <summary>The same with checks: for a cluster that is shorter than the others, that has the last vertex, behind which there is no number, or a
    /// wrong index.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private (Vector256<double> Low, Vector256<double> High) AroundChecked(int first, int end)
    {
        var low = Vector256.Create(double.PositiveInfinity);
        var high = -low;
        for (var i = 3 * first; i < 3 * end; i++)
        {
            var corner = CornerAt(i);
            (low, high) = (Lanes.MinOrLast(corner, low), Lanes.MaxOrLast(corner, high));
        }
        return (low, high);
    }

    /// <summary>Whether all indices of a cluster are valid, and none is the last vertex.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private bool AreBeforeTheLast(int first, int end)
    {
        var vertexIndices = new RawSpan<int>(indices);
        var most = Vector256<uint>.Zero; // as unsigned numbers, negative indices are the largest
        for (var i = first; i < end; i += Vector256<int>.Count)
            most = Vector256.Max(most, vertexIndices.Load256(i).AsUInt32());
        return Vector256.LessThanAll(most, Vector256.Create((uint)Math.Max(vertices.Length - 1, 0)));
    }

    /// <summary>Prefetches indices and vertices. Most vertices lie next to others, so some of a cluster's are enough.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Prefetch(int first)
    {
        var vertexIndices = new RawSpan<int>(indices);
        for (var i = 3 * first; i < 3 * (first + ClusterLength); i += ClusterLength)
        {
            Lanes.Prefetch(ref vertexIndices[i + 3 * IndicesAhead]);
            PrefetchVertex(vertexIndices[i + 3 * VerticesAhead]);
            PrefetchVertex(vertexIndices[i + 3 * VerticesAhead + 1]);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void PrefetchVertex(int index)
    {
        if ((uint)index < (uint)vertices.Length) Lanes.Prefetch(ref new RawSpan<Vector3>(vertices)[index]); // not checked yet
    }
}
