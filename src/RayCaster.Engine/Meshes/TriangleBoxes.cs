using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace RayCaster.Engine;

/// <summary>The boxes around triangles of a mesh that follow one another. Here each index is checked, once for all.</summary>
/// <param name="vertices">The corners.</param>
/// <param name="indices">Three for each triangle.</param>
internal sealed class TriangleBoxes(Vector3[] vertices, int[] indices)
{
    /// <summary>
    /// How far ahead the memory is asked for: to wait for it would take longer than to find the boxes. Vertices are asked for later than indices, since their
    /// places must be there.
    /// </summary>
    private const int VerticesAhead = 6 * Group.Length, IndicesAhead = 24 * Group.Length;

    /// <summary>
    /// The least and the greatest coordinates, behind a number that means nothing. A corner that is no number does not count, for it is part of no hit.
    /// </summary>
    /// <param name="first">The first triangle.</param>
    /// <param name="end">The one after the last.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public (Vector256<double> Low, Vector256<double> High) Around(int first, int end)
    {
        ref var index = ref indices[3 * first];
        ref var vertex = ref MemoryMarshal.GetArrayDataReference(vertices);
        Check(ref index, 3 * (end - first));
        if (first + IndicesAhead + Group.Length <= indices.Length / 3) Fetch(ref vertex, ref index);

        // Each corner has bounds of its own, so that no comparison waits for the one before it.
        var none = Vector256.Create(double.PositiveInfinity);
        var (lowA, lowB, lowC) = (none, none, none);
        var (highA, highB, highC) = (-none, -none, -none);
        for (var i = first; i < end; i++, index = ref Unsafe.Add(ref index, 3))
        {
            var (a, b, c) = (Corner(ref vertex, ref index, 0), Corner(ref vertex, ref index, 1), Corner(ref vertex, ref index, 2));
            (lowA, lowB, lowC) = (Vector256.MinNative(a, lowA), Vector256.MinNative(b, lowB), Vector256.MinNative(c, lowC));
            (highA, highB, highC) = (Vector256.MaxNative(a, highA), Vector256.MaxNative(b, highB), Vector256.MaxNative(c, highC));
        }
        return (Vector256.MinNative(Vector256.MinNative(lowA, lowB), lowC), Vector256.MaxNative(Vector256.MaxNative(highA, highB), highC));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<double> Corner(ref Vector3 vertex, ref int index, int corner) =>
        Lanes.NumberAndPoint(ref Unsafe.Add(ref vertex, Unsafe.Add(ref index, corner)));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Check(ref int index, int count)
    {
        var most = Vector256<uint>.Zero; // a negative index is a larger one than all
        var i = 0;
        for (; i <= count - Vector256<int>.Count; i += Vector256<int>.Count)
            most = Vector256.Max(most, Vector256.LoadUnsafe(ref Unsafe.Add(ref index, i)).AsUInt32());
        if (!Vector256.LessThanAll(most, Vector256.Create((uint)vertices.Length))) throw new IndexOutOfRangeException();
        for (; i < count; i++) _ = vertices[Unsafe.Add(ref index, i)];
    }

    /// <summary>Most vertices are neighbours of others: some of those of a group are enough.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Fetch(ref Vector3 vertex, ref int index)
    {
        for (var i = 0; i < 3 * Group.Length; i += Group.Length)
        {
            Lanes.Fetch(ref Unsafe.Add(ref index, 3 * IndicesAhead + i));
            FetchVertex(ref vertex, Unsafe.Add(ref index, 3 * VerticesAhead + i));
            FetchVertex(ref vertex, Unsafe.Add(ref index, 3 * VerticesAhead + i + 1));
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void FetchVertex(ref Vector3 vertex, int index)
    {
        if ((uint)index < (uint)vertices.Length) Lanes.Fetch(ref Unsafe.Add(ref vertex, index)); // it is not checked yet
    }
}
