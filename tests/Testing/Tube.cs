namespace RayCaster.Testing;

/// <summary>The <see cref="Cylinder"/> as docs/adding-a-primitive.md shows it a second time: one formula over any kind of number.</summary>
public readonly record struct Tube(Vector3 Center, double Radius, double Height) : IPrimitive
{
    public Crossings<N> Intersect<N>(in Ray<N> ray) where N : struct, IReal<N>
    {
        var CP = (ray.Origin - Center).As("CP");
        var d = ray.Direction;

        var a = (d.X * d.X + d.Y * d.Y).As("a");
        var b = (CP.X * d.X + CP.Y * d.Y).As("b");
        var c = (CP.X * CP.X + CP.Y * CP.Y - Radius * Radius).As("c");
        var root = N.Sqrt(b * b - a * c).As("root"); // NaN where the ray misses
        return new(IfOnTube((-b - root) / a, CP, d), IfOnTube((-b + root) / a, CP, d));
    }

    private N IfOnTube<N>(N t, Vector3<N> CP, Vector3<N> d) where N : struct, IReal<N>
    {
        var z = (CP.Z + t * d.Z).As("z");
        return N.If((z >= -Height / 2) & (z <= Height / 2), t);
    }
}
