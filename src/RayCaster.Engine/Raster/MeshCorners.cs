namespace RayCaster.Engine;

/// <summary>The corners of a mesh's triangles. They are projected at each use: storing all projected vertices takes longer, because memory is slower
/// than arithmetic.</summary>
internal sealed class MeshCorners<N>(ScreenSpace screen, Vector3[] vertices, int[] indices) : CornerSource where N : struct, IPacket<N>
{
    private const int IndicesPerCacheLine = 16;

    public override int Count => indices.Length / 3;

    public override void Project(ReadOnlySpan<int> triangles, out EightTriangles seen)
    {
        Project(triangles, 0, out seen.A);
        Project(triangles, 1, out seen.B);
        Project(triangles, 2, out seen.C);
    }

    public override void Prefetch(int first, int count)
    {
        for (var i = 3 * first; i < 3 * (first + count) && i < indices.Length; i += IndicesPerCacheLine) Lanes.Prefetch(ref indices[i]);
    }

    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    public override void PrefetchVertices(int first, int count)
    {
        if (first + count > Count) return;
        var points = new RawSpan<Vector3>(vertices);
        var vertexIndices = new RawSpan<int>(indices);
        var step = count > 1 ? 4 : 1; // most vertices are next to others
        for (var i = 3 * first; i < 3 * (first + count); i += step) Lanes.Prefetch(ref points[vertexIndices[i]]);
    }

    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private void Project(ReadOnlySpan<int> triangles, int corner, out EightPoints seen)
    {
        var names = new RawSpan<int>(triangles);
        var lower = screen.Project(N.Gather(vertices, indices, names, 0, corner));
        var upper = N.Count == 8 ? lower : screen.Project(N.Gather(vertices, indices, names, N.Count, corner));
        seen = new(N.Narrow(lower.X, upper.X), N.Narrow(lower.Y, upper.Y), N.Narrow(lower.InverseDepth, upper.InverseDepth));
    }
}
