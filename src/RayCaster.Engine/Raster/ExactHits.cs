namespace RayCaster.Engine;

/// <summary>Computes where each ray of a packet hits its own triangle, by the triangle's formula.</summary>
internal sealed class ExactHits<N>(ScreenSpace screen) where N : struct, IPacket<N>
{
    private readonly double[] columns = new double[N.Count], rows = new double[N.Count];
    private readonly double[] hits = new double[N.Count], inverseDepth = new double[N.Count];
    private readonly int[] triangles = new int[N.Count], pixels = new int[N.Count];
    private Vector3[] vertices = [];
    private int[] indices = [];
    private int count;

    public void SetMesh(Vector3[] vertices, int[] indices) => (this.vertices, this.indices) = (vertices, indices);

    /// <summary>Where rays cross triangles, a lane for each pair.</summary>
    /// <param name="first">The position of the first lane's triangle; the other lanes' follow.</param>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    public Crossings<N> Intersect(in Ray<N> rays, RawSpan<int> triangles, int first) => Triangle.Intersect(
        new RaySpace<N>(rays), Corner(triangles, first, 0), Corner(triangles, first, 1), Corner(triangles, first, 2));

    // not inlined three times: in a larger method, the compiler would turn operators into calls
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private Vector3<N> Corner(RawSpan<int> triangles, int first, int corner) => N.Gather(vertices, indices, triangles, first, corner);

    /// <summary>Adds a pixel and a triangle to the next packet. Its t is kept if it is less than the one so far.</summary>
    /// <param name="pixel">The pixel's position in both arrays.</param>
    /// <param name="least">The least t of each pixel so far.</param>
    /// <param name="occluderInverseDepth">The greatest inverse depth of each pixel so far, less its rounding error.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Add(int column, int row, int triangle, int pixel, double[] least, float[] occluderInverseDepth)
    {
        (columns[count], rows[count], triangles[count], pixels[count]) = (column, row, triangle, pixel);
        if (++count == N.Count) Flush(least, occluderInverseDepth);
    }

    public void Flush(double[] least, float[] occluderInverseDepth)
    {
        if (count == 0) return;
        for (var i = count; i < N.Count; i++) (columns[i], rows[i], triangles[i]) = (columns[0], rows[0], triangles[0]);
        Compute();
        for (var i = 0; i < count; i++)
        {
            if (!(hits[i] < least[pixels[i]])) continue;
            least[pixels[i]] = hits[i];
            occluderInverseDepth[pixels[i]] = Math.Max(occluderInverseDepth[pixels[i]], (float)inverseDepth[i]);
        }
        count = 0;
    }

    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private void Compute()
    {
        var direction = screen.Camera.Direction(N.Load(columns, 0), N.Load(rows, 0));
        var crossings = Intersect(new Ray<N>(screen.Camera.Position, direction), new(triangles), 0);
        var hit = screen.Camera.ClipRange.First(crossings, screen.Camera.DepthPerT(direction));
        hit.Store(hits, 0);
        (Lanes.Broadcast<N>(screen.ReferenceDepth * (1 - 1e-5)) / (hit * -(direction * (Vector3<N>)screen.Camera.W))).Store(inverseDepth, 0);
    }
}
