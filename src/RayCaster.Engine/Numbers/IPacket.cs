namespace RayCaster.Engine;

/// <summary>Numbers of several pixels side by side; as a mask all bits of a lane set for true, none for false.</summary>
internal interface IPacket<N> : IReal<N> where N : struct, IPacket<N>
{
    static abstract int Count { get; }

    /// <summary>Where a equals b; false where either is NaN.</summary>
    static abstract N Equal(N a, N b);

    /// <summary>A bit for each lane of a mask, the first lane's the lowest.</summary>
    static abstract uint Bits(N mask);

    /// <summary>a b + c, rounded once or twice; so it must not be used in a formula.</summary>
    static abstract N MultiplyAddEstimate(N a, N b, N c);

    static abstract double Greatest(N a);

    /// <summary>first, first + 1, first + 2 …</summary>
    static abstract N Sequence(int first);

    static abstract N Load(double[] numbers, int first);

    /// <inheritdoc cref="Load(double[], int)"/>
    static abstract N Load(float[] numbers, int first);

    /// <summary>A corner of several triangles, one in each lane. The mesh's indices have been checked.</summary>
    /// <param name="first">The position of the first lane's triangle; the other lanes' follow.</param>
    static abstract Vector3<N> Gather(Vector3[] vertices, int[] indices, RawSpan<int> triangles, int first, int corner);

    /// <summary>Eight numbers as floats; a packet of eight ignores the upper one.</summary>
    static abstract Vector256<float> Narrow(N lower, N upper);

    void Store(double[] numbers, int first);
}
