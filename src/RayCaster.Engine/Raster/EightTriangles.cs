namespace RayCaster.Engine;

/// <summary>The corners of eight triangles on the screen, a triangle to a lane.</summary>
internal struct EightTriangles
{
    public EightPoints A, B, C;

    public readonly Vector256<float> MaxInverseDepth
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Lanes.MaxOrLast(A.InverseDepth, B.InverseDepth, C.InverseDepth);
    }

    public readonly Vector256<float> MinInverseDepth
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Lanes.MinOrLast(A.InverseDepth, B.InverseDepth, C.InverseDepth);
    }
}

/// <summary>Eight points on the screen: columns, rows and inverse depths.</summary>
internal readonly struct EightPoints(Vector256<float> x, Vector256<float> y, Vector256<float> inverseDepth)
{
    public readonly Vector256<float> X = x, Y = y, InverseDepth = inverseDepth;
}
