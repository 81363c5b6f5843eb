namespace RayCaster.Engine;

/// <summary>The corners of eight triangles on the screen, a triangle to a lane.</summary>
internal struct EightTriangles
{
    public EightPoints A, B, C;
}

/// <summary>Eight points on the screen: columns, rows and w.</summary>
internal readonly struct EightPoints(Vector256<float> x, Vector256<float> y, Vector256<float> w)
{
    public readonly Vector256<float> X = x, Y = y, W = w;
}
