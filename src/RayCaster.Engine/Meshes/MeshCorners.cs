using System.Runtime.CompilerServices;

namespace RayCaster.Engine;

/// <summary>The corners of a mesh's triangles. They are projected at each use: storing all projected vertices takes longer, because memory is slower
/// than arithmetic.</summary>
internal sealed class MeshCorners<N>(ScreenSpace screen, Vector3[] vertices, int[] indices) : Corners where N : struct, IPacket<N>
{
    public override int Count => indices.Length / 3;

    public override void See(ReadOnlySpan<int> triangles, out EightTriangles seen)
    {
        See(triangles, 0, out seen.A);
        See(triangles, 1, out seen.B);
        See(triangles, 2, out seen.C);
    }

    public override void Fetch(int group)
    {
        for (var i = 0; i < 3; i++) Lanes.Fetch(ref indices[Math.Min(3 * group + i * TriangleCluster.Length, indices.Length - 1)]);
    }

    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    public override void FetchVertices(int group)
    {
        if (group + TriangleCluster.Length > Count) return;
        var points = new RawSpan<Vector3>(vertices);
        var places = new RawSpan<int>(indices);
        for (var i = 3 * group; i < 3 * (group + TriangleCluster.Length); i += 9) // most vertices are next to others
        {
            Lanes.Fetch(ref points[places[i]]);
            Lanes.Fetch(ref points[places[i + 1]]);
        }
    }

    public override void Fetch(ReadOnlySpan<int> triangles)
    {
        foreach (var triangle in triangles) Lanes.Fetch(ref indices[3 * triangle]);
    }

    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    public override void FetchVertices(ReadOnlySpan<int> triangles)
    {
        var points = new RawSpan<Vector3>(vertices);
        foreach (var triangle in triangles)
            for (var i = 3 * triangle; i < 3 * triangle + 3; i++) Lanes.Fetch(ref points[indices[i]]);
    }

    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private void See(ReadOnlySpan<int> triangles, int corner, out EightPoints seen)
    {
        var names = new RawSpan<int>(triangles);
        var lower = screen.Project(N.Gather(vertices, indices, names, 0, corner));
        var upper = N.Count == 8 ? lower : screen.Project(N.Gather(vertices, indices, names, N.Count, corner));
        seen = new(N.Narrow(lower.X, upper.X), N.Narrow(lower.Y, upper.Y), N.Narrow(lower.W, upper.W));
    }
}
