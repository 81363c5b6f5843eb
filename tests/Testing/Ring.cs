using System.Runtime.CompilerServices;

namespace RayCaster.Testing;

/// <summary>A flat disc with a hole: a shape that somebody adds as a formula over any kind of number.</summary>
public readonly record struct Ring(Vector3 Center, Vector3 Normal, double Inner, double Outer) : IPrimitive
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Crossings<N> Intersect<N>(in Ray<N> ray) where N : struct, IReal<N>
    {
        var t = new Plane(Center, Normal).Intersect(ray).Near;
        var CX = ray.At(t) - Center;
        var square = CX * CX;
        return new(N.If((square >= Inner * Inner) & (square <= Outer * Outer), t));
    }
}
