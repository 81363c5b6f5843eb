using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace RayCaster.Engine;

/// <summary>
/// The corners of a mesh's triangles, projected each time that they are asked for: to write all vertices' places on the screen to an array first, and to
/// read them from there, takes longer, for memory is slower than arithmetic.
/// </summary>
/// <param name="screen">The camera.</param>
/// <param name="vertices">The corners.</param>
/// <param name="indices">Three for each triangle, all of them places of vertices.</param>
internal sealed class MeshCorners(ScreenSpace screen, Vector3[] vertices, int[] indices) : Corners
{
    /// <inheritdoc/>
    public override int Count => indices.Length / 3;

    /// <inheritdoc/>
    public override void See(ReadOnlySpan<int> triangles, out EightTriangles seen)
    {
        See(triangles, 0, out seen.A);
        See(triangles, 1, out seen.B);
        See(triangles, 2, out seen.C);
    }

    /// <inheritdoc/>
    public override void SeeRun(int first, out EightTriangles seen)
    {
        if (!Vector512.IsHardwareAccelerated || first + 8 > Count)
        {
            base.SeeRun(first, out seen);
            return;
        }
        SeeRun(first, 0, out seen.A);
        SeeRun(first, 1, out seen.B);
        SeeRun(first, 2, out seen.C);
    }

    /// <inheritdoc/>
    public override void Fetch(int group)
    {
        ref var index = ref indices[3 * group];
        Lanes.Fetch(ref index);
        Lanes.Fetch(ref Unsafe.Add(ref index, Group.Length));
        Lanes.Fetch(ref Unsafe.Add(ref index, 2 * Group.Length));
    }

    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    public override void FetchVertices(int group)
    {
        if (group + Group.Length > Count) return;
        ref var index = ref Unsafe.Add(ref MemoryMarshal.GetArrayDataReference(indices), 3 * group);
        ref var vertex = ref MemoryMarshal.GetArrayDataReference(vertices);
        for (var i = 0; i < 3 * Group.Length; i += 9) // most are neighbours of others
        {
            Lanes.Fetch(ref Unsafe.Add(ref vertex, Unsafe.Add(ref index, i)));
            Lanes.Fetch(ref Unsafe.Add(ref vertex, Unsafe.Add(ref index, i + 1)));
        }
    }

    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private void See(ReadOnlySpan<int> triangles, int corner, out EightPoints seen)
    {
        ref var triangle = ref MemoryMarshal.GetReference(triangles);
        if (Vector512.IsHardwareAccelerated)
        {
            var (x, y, w) = screen.Project(Lanes.Gather(vertices, indices, ref triangle, corner));
            seen = new(Lanes.Narrow(x), Lanes.Narrow(y), Lanes.Narrow(w));
            return;
        }
        var (x0, y0, w0) = screen.Project(Lanes.GatherFour(vertices, indices, ref triangle, corner));
        var (x4, y4, w4) = screen.Project(Lanes.GatherFour(vertices, indices, ref Unsafe.Add(ref triangle, 4), corner));
        seen = new(Lanes.Narrow(x0, x4), Lanes.Narrow(y0, y4), Lanes.Narrow(w0, w4));
    }

    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private void SeeRun(int first, int corner, out EightPoints seen)
    {
        var (x, y, w) = screen.Project(Lanes.GatherRun(vertices, indices, first, corner));
        seen = new(Lanes.Narrow(x), Lanes.Narrow(y), Lanes.Narrow(w));
    }
}
