using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace RayCaster.Engine;

/// <summary>The boxes around triangles of a mesh that follow one another. Here each index is checked, once for all.</summary>
/// <param name="vertices">The corners.</param>
/// <param name="indices">Three for each triangle.</param>
internal sealed class TriangleBoxes(Vector3[] vertices, int[] indices)
{
    /// <summary>
    /// How far ahead the memory is asked for: to wait for it would take longer than to find the boxes. Vertices are asked for later than indices,
    /// since their
    /// places must be there.
    /// </summary>
    private const int VerticesAhead = 6 * TriangleCluster.Length, IndicesAhead = 24 * TriangleCluster.Length;

    /// <summary>The least and the greatest coordinates of some triangles, and a fourth number that means nothing. A corner that is no number does
    /// not
    /// count, for it is part of no hit.</summary>
    /// <param name="first">The first triangle.</param>
    /// <param name="end">The one after the last.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public (Vector256<double> Low, Vector256<double> High) Around(int first, int end)
    {
        if (end - first != TriangleCluster.Length || !AreBeforeTheLast(3 * first)) return AroundFew(first, end);
        var places = new RawSpan<int>(indices);
        var numbers = RawSpan.NumbersOf(vertices);
        if (first + IndicesAhead + TriangleCluster.Length <= indices.Length / 3) Fetch(first);

        // Each corner has bounds of its own, so that no comparison waits for the one before it.
        var none = Vector256.Create(double.PositiveInfinity);
        var (lowA, lowB, lowC) = (none, none, none);
        var (highA, highB, highC) = (-none, -none, -none);
        for (var i = 3 * first; i < 3 * end; i += 3)
        {
            // A vertex's three numbers and the one behind them, which is the next vertex's.
            var (a, b, c) = (numbers.Load256(3 * places[i]), numbers.Load256(3 * places[i + 1]), numbers.Load256(3 * places[i + 2]));
            (lowA, lowB, lowC) = (Vector256.MinNative(a, lowA), Vector256.MinNative(b, lowB), Vector256.MinNative(c, lowC));
            (highA, highB, highC) = (Vector256.MaxNative(a, highA), Vector256.MaxNative(b, highB), Vector256.MaxNative(c, highC));
        }
        return (Vector256.MinNative(Vector256.MinNative(lowA, lowB), lowC), Vector256.MaxNative(Vector256.MaxNative(highA, highB), highC));
    }

    /// <summary>The same for a group that has the last vertex, behind which there is no number, or not the length of the others; and where an index
    /// is wrong.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private (Vector256<double> Low, Vector256<double> High) AroundFew(int first, int end)
    {
        var low = Vector256.Create(double.PositiveInfinity);
        var high = -low;
        for (var i = 3 * first; i < 3 * end; i++)
        {
            var point = vertices[indices[i]];
            var corner = Vector256.Create(point.X, point.Y, point.Z, 0);
            (low, high) = (Vector256.MinNative(corner, low), Vector256.MaxNative(corner, high));
        }
        return (low, high);
    }

    /// <summary>Whether all indices of a group are places of vertices, and none that of the last.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private bool AreBeforeTheLast(int first)
    {
        var places = new RawSpan<int>(indices);
        var most = Vector256<uint>.Zero; // a negative index is a larger one than all
        for (var i = first; i < first + 3 * TriangleCluster.Length; i += Vector256<int>.Count)
            most = Vector256.Max(most, places.Load256(i).AsUInt32());
        return Vector256.LessThanAll(most, Vector256.Create((uint)vertices.Length - 1));
    }

    /// <summary>Most vertices are neighbours of others: some of those of a group are enough.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Fetch(int first)
    {
        var places = new RawSpan<int>(indices);
        for (var i = 3 * first; i < 3 * (first + TriangleCluster.Length); i += TriangleCluster.Length)
        {
            Lanes.Fetch(ref places[i + 3 * IndicesAhead]);
            FetchVertex(places[i + 3 * VerticesAhead]);
            FetchVertex(places[i + 3 * VerticesAhead + 1]);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void FetchVertex(int index)
    {
        if ((uint)index < (uint)vertices.Length) Lanes.Fetch(ref new RawSpan<Vector3>(vertices)[index]); // it is not checked yet
    }
}
