using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace RayCaster.Engine;

/// <summary>Moves numbers between arrays of things and lanes, where lane = thing.</summary>
internal static class Lanes
{
    /// <summary>One number in all lanes: the compiler finds the conversion only through this constraint.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static N Broadcast<N>(double number) where N : struct, IReal<N> => number;

    /// <summary>A corner of each of eight triangles of a mesh whose indices are known to be right.</summary>
    /// <param name="vertices">The corners.</param>
    /// <param name="indices">Three for each triangle.</param>
    /// <param name="triangle">The first of eight triangles.</param>
    /// <param name="corner">Which corner.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3<WidePacket> Gather(Vector3[] vertices, int[] indices, ref int triangle, int corner)
    {
        ref var index = ref Unsafe.Add(ref MemoryMarshal.GetArrayDataReference(indices), corner);
        ref var vertex = ref MemoryMarshal.GetArrayDataReference(vertices);
        return Transpose(
            Corner(ref vertex, ref index, ref triangle, 0), Corner(ref vertex, ref index, ref triangle, 1),
            Corner(ref vertex, ref index, ref triangle, 2), Corner(ref vertex, ref index, ref triangle, 3),
            Corner(ref vertex, ref index, ref triangle, 4), Corner(ref vertex, ref index, ref triangle, 5),
            Corner(ref vertex, ref index, ref triangle, 6), Corner(ref vertex, ref index, ref triangle, 7));
    }

    /// <summary>The same of triangles that follow one another.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3<WidePacket> GatherRun(Vector3[] vertices, int[] indices, int triangle, int corner)
    {
        ref var index = ref Unsafe.Add(ref MemoryMarshal.GetArrayDataReference(indices), 3 * triangle + corner);
        ref var vertex = ref MemoryMarshal.GetArrayDataReference(vertices);
        return Transpose(
            Corner(ref vertex, ref index, 0), Corner(ref vertex, ref index, 1), Corner(ref vertex, ref index, 2), Corner(ref vertex, ref index, 3),
            Corner(ref vertex, ref index, 4), Corner(ref vertex, ref index, 5), Corner(ref vertex, ref index, 6), Corner(ref vertex, ref index, 7));
    }

    /// <summary>Eight times a number and a point as the points of eight lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3<WidePacket> Transpose(Vector256<double> p0, Vector256<double> p1, Vector256<double> p2, Vector256<double> p3,
        Vector256<double> p4, Vector256<double> p5, Vector256<double> p6, Vector256<double> p7)
    {
        if (!Avx512F.IsSupported)
        {
            Vector512<double> Of(int i) => Vector512.Create(p0[i], p1[i], p2[i], p3[i], p4[i], p5[i], p6[i], p7[i]);
            return new(new(Of(1)), new(Of(2)), new(Of(3)));
        }
        var (p04, p15) = (Pair(p0, p4), Pair(p1, p5));
        var (p26, p37) = (Pair(p2, p6), Pair(p3, p7));
        var (xz01, xz23) = (Avx512F.UnpackHigh(p04, p15), Avx512F.UnpackHigh(p26, p37));
        var (y01, y23) = (Avx512F.UnpackLow(p04, p15), Avx512F.UnpackLow(p26, p37));
        var (even, odd) = (Vector512.Create(0L, 1, 8, 9, 4, 5, 12, 13), Vector512.Create(2L, 3, 10, 11, 6, 7, 14, 15));
        return new(
            new(Avx512F.PermuteVar8x64x2(xz01, even, xz23)),
            new(Avx512F.PermuteVar8x64x2(y01, odd, y23)),
            new(Avx512F.PermuteVar8x64x2(xz01, odd, xz23)));
    }

    /// <summary>Two halves; <see cref="Vector512.Create{T}(Vector256{T}, Vector256{T})"/> would clear the upper one before it is set.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> Pair(Vector256<double> lower, Vector256<double> upper) => lower.ToVector512Unsafe().WithUpper(upper);

    /// <summary>The same of four triangles.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3<Packet> GatherFour(Vector3[] vertices, int[] indices, ref int triangle, int corner)
    {
        ref var index = ref Unsafe.Add(ref MemoryMarshal.GetArrayDataReference(indices), corner);
        ref var vertex = ref MemoryMarshal.GetArrayDataReference(vertices);
        return Transpose(Corner(ref vertex, ref index, ref triangle, 0), Corner(ref vertex, ref index, ref triangle, 1),
            Corner(ref vertex, ref index, ref triangle, 2), Corner(ref vertex, ref index, ref triangle, 3));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<double> Corner(ref Vector3 vertex, ref int index, ref int triangle, int lane) =>
        NumberAndPoint(ref Unsafe.Add(ref vertex, Unsafe.Add(ref index, 3 * Unsafe.Add(ref triangle, lane))));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<double> Corner(ref Vector3 vertex, ref int index, int lane) =>
        NumberAndPoint(ref Unsafe.Add(ref vertex, Unsafe.Add(ref index, 3 * lane)));

    /// <summary>Four times a number and a point as the points of four lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3<Packet> Transpose(Vector256<double> p0, Vector256<double> p1, Vector256<double> p2, Vector256<double> p3)
    {
        if (!Avx2.IsSupported)
        {
            Vector256<double> Of(int i) => Vector256.Create(p0[i], p1[i], p2[i], p3[i]);
            return new(new(Of(1)), new(Of(2)), new(Of(3)));
        }
        var (xz01, xz23) = (Avx.UnpackHigh(p0, p1), Avx.UnpackHigh(p2, p3));
        var (y01, y23) = (Avx.UnpackLow(p0, p1), Avx.UnpackLow(p2, p3));
        return new(
            new(Avx.Permute2x128(xz01, xz23, 0x20)), new(Avx.Permute2x128(y01, y23, 0x31)), new(Avx.Permute2x128(xz01, xz23, 0x31)));
    }

    /// <summary>
    /// The number before a point of an array, and the point, read at once. What lies before the first point of an array is the array's length, so nothing
    /// beyond the array is read.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<double> NumberAndPoint(ref Vector3 point) =>
        Vector256.LoadUnsafe(ref Unsafe.Subtract(ref Unsafe.As<Vector3, double>(ref point), 1));

    /// <summary>Asks the memory for something that is needed soon. The pointer is only a hint: nothing is read through it, wherever the thing may be moved.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe void Fetch<T>(ref T thing) where T : struct
    {
        if (Sse.IsSupported) Sse.Prefetch0(Unsafe.AsPointer(ref thing));
    }

    /// <summary>Eight doubles as floats.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> Narrow(WidePacket x) => Avx512F.IsSupported
        ? Avx512F.ConvertToVector256Single(x.Lanes)
        : Vector256.Narrow(x.Lanes.GetLower(), x.Lanes.GetUpper());

    /// <inheritdoc cref="Narrow(WidePacket)"/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> Narrow(Packet lower, Packet upper) => Vector256.Narrow(lower.Lanes, upper.Lanes);

    /// <summary>The least of three in each lane; of NaN it promises nothing.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> Least(Vector256<float> a, Vector256<float> b, Vector256<float> c) =>
        Vector256.MinNative(a, Vector256.MinNative(b, c));

    /// <summary>The greatest of three in each lane; of NaN it promises nothing.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> Most(Vector256<float> a, Vector256<float> b, Vector256<float> c) =>
        Vector256.MaxNative(a, Vector256.MaxNative(b, c));
}
