using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace RayCaster;

/// <summary>
/// The corners of a mesh's triangles, projected each time that they are asked for: to read all vertices' places on the screen from an array, and to
/// write them there first, takes longer, for memory is slower than arithmetic.
/// </summary>
/// <param name="screen">The camera.</param>
/// <param name="vertices">The corners.</param>
/// <param name="indices">Three for each triangle, all of them places of vertices.</param>
internal sealed class MeshCorners(ScreenSpace screen, Vector3[] vertices, int[] indices) : Corners
{
    /// <inheritdoc/>
    public override int Count => indices.Length / 3;

    /// <inheritdoc/>
    public override void See(ReadOnlySpan<int> triangles, out EightTriangles seen) =>
        seen = new(See(triangles, 0), See(triangles, 1), See(triangles, 2));

    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private EightPoints See(ReadOnlySpan<int> triangles, int corner)
    {
        ref var triangle = ref MemoryMarshal.GetReference(triangles);
        if (Vector512.IsHardwareAccelerated)
        {
            var (x, y, w) = screen.Project(Lanes.Gather(vertices, indices, ref triangle, corner));
            return new(Lanes.Narrow(x), Lanes.Narrow(y), Lanes.Narrow(w));
        }
        var (x0, y0, w0) = screen.Project(Lanes.GatherFour(vertices, indices, ref triangle, corner));
        var (x4, y4, w4) = screen.Project(Lanes.GatherFour(vertices, indices, ref Unsafe.Add(ref triangle, 4), corner));
        return new(Lanes.Narrow(x0, x4), Lanes.Narrow(y0, y4), Lanes.Narrow(w0, w4));
    }
}
