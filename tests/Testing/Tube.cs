namespace RayCaster.Testing;

/// <summary>The <see cref="Cylinder"/> as docs/adding-a-primitive.md shows it a second time: one formula over any kind of number.</summary>
public readonly record struct Tube(Vector3 Center, double Radius, double Height) : IPrimitive
{
    public Crossings<N> Intersect<N>(in Ray<N> ray) where N : struct, IReal<N>
    {
        var P = (ray.Origin - Center).As("P");
        var d = ray.Direction;

        var a = (d.X * d.X + d.Y * d.Y).As("a");
        var b = (P.X * d.X + P.Y * d.Y).As("b");
        var c = (P.X * P.X + P.Y * P.Y - Radius * Radius).As("c");
        var root = N.Sqrt(b * b - a * c).As("root"); // NaN where the ray misses
        return new(IfOnTube((-b - root) / a, P, d), IfOnTube((-b + root) / a, P, d));
    }

    private N IfOnTube<N>(N t, Vector3<N> P, Vector3<N> d) where N : struct, IReal<N>
    {
        var z = P.Z + t * d.Z;
        return N.If((z >= -Height / 2) & (z <= Height / 2), t);
    }
}
