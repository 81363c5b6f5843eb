using System.Runtime.Intrinsics;

namespace RayCaster.Engine;

/// <summary>Numbers of several pixels side by side; as a mask all bits of a lane set for true, none for false.</summary>
/// <typeparam name="N">The packet itself.</typeparam>
internal interface IPacket<N> : IReal<N> where N : struct, IPacket<N>
{
    /// <summary>How many pixels there are in a packet.</summary>
    static abstract int Count { get; }

    /// <summary>Where a equals b; false where either is NaN.</summary>
    static abstract N Equal(N a, N b);

    /// <summary>Whether a mask holds in every lane.</summary>
    static abstract bool All(N mask);

    /// <summary>A bit for each lane of a mask, the first lane's the lowest.</summary>
    static abstract uint Bits(N mask);

    /// <summary>a b + c, rounded once or twice: not for a formula, whose every operation rounds once.</summary>
    static abstract N MultiplyAddEstimate(N a, N b, N c);

    /// <summary>The greatest of the lanes.</summary>
    static abstract double Greatest(N a);

    /// <summary>first, first + 1, first + 2 …</summary>
    static abstract N Sequence(int first);

    /// <summary>The packet that begins at a place in an array.</summary>
    static abstract N Load(double[] numbers, int first);

    /// <summary>A corner of triangles of a mesh, one to each lane; see <see cref="Lanes"/>.</summary>
    static abstract Vector3<N> Gather(Vector3[] vertices, int[] indices, ref int triangle, int corner);

    /// <summary>Points, one to each lane, of which each is the last three of four numbers.</summary>
    static abstract Vector3<N> Transpose(ref Vector256<double> first);

    /// <summary>Puts the packet at a place in an array.</summary>
    void Store(double[] numbers, int first);

    /// <summary>Puts numbers that are whole and within ±2³¹ there.</summary>
    void StoreWhole(int[] numbers, int first);
}
