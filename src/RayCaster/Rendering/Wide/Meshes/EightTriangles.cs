using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace RayCaster;

/// <summary>The corners of eight triangles on the screen, a triangle to a lane.</summary>
internal readonly struct EightTriangles
{
    public readonly Vector256<float> AX, AY, AW, BX, BY, BW, CX, CY, CW;

    /// <summary>Not 0 where a corner is not fit for floats.</summary>
    public readonly Vector256<float> Unfit;

    /// <param name="points">x, y, w and whether it is unfit, of each vertex.</param>
    /// <param name="indices">Three vertices for each triangle.</param>
    /// <param name="triangles">Which eight triangles.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public EightTriangles(Vector128<float>[] points, int[] indices, ReadOnlySpan<int> triangles)
    {
        (AX, AY, AW, var a) = Corners(points, indices, triangles, 0);
        (BX, BY, BW, var b) = Corners(points, indices, triangles, 1);
        (CX, CY, CW, var c) = Corners(points, indices, triangles, 2);
        Unfit = a + b + c;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static (Vector256<float> X, Vector256<float> Y, Vector256<float> Z, Vector256<float> W) Corners(
        Vector128<float>[] points, int[] indices, ReadOnlySpan<int> t, int k)
    {
        ref var corner = ref Unsafe.Add(ref MemoryMarshal.GetArrayDataReference(indices), k); // the triangles are there; their vertices are checked
        return Lanes.Transpose(
            points[Unsafe.Add(ref corner, 3 * t[0])], points[Unsafe.Add(ref corner, 3 * t[1])],
            points[Unsafe.Add(ref corner, 3 * t[2])], points[Unsafe.Add(ref corner, 3 * t[3])],
            points[Unsafe.Add(ref corner, 3 * t[4])], points[Unsafe.Add(ref corner, 3 * t[5])],
            points[Unsafe.Add(ref corner, 3 * t[6])], points[Unsafe.Add(ref corner, 3 * t[7])]);
    }
}
