using System.Runtime.Intrinsics;

namespace RayCaster;

/// <summary>The corners of eight triangles on the screen, a triangle to a lane: columns, rows and w.</summary>
internal readonly struct EightTriangles(in EightPoints a, in EightPoints b, in EightPoints c)
{
    public readonly Vector256<float> AX = a.X, AY = a.Y, AW = a.W, BX = b.X, BY = b.Y, BW = b.W, CX = c.X, CY = c.Y, CW = c.W;
}

/// <summary>Eight points on the screen.</summary>
internal readonly struct EightPoints(Vector256<float> x, Vector256<float> y, Vector256<float> w)
{
    public readonly Vector256<float> X = x, Y = y, W = w;
}
