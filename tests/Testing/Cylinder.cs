namespace RayCaster.Testing;

/// <summary>An upright tube without lids, written as docs/adding-a-primitive.md shows it: plain doubles and ifs, no number type.</summary>
public sealed class Cylinder(Vector3 center, double radius, double height) : Model
{
    public override double? Intersect(Ray ray)
    {
        var (CP, d) = (ray.Origin - center, ray.Direction);

        // |X − C| = R in the xy plane: a t² + 2 b t + c = 0, so t = (−b ∓ √(b² − a c)) / a. The slide has b for our 2 b, hence its 4 and 2.
        var a = d.X * d.X + d.Y * d.Y;
        var b = CP.X * d.X + CP.Y * d.Y;
        var c = CP.X * CP.X + CP.Y * CP.Y - radius * radius;
        var discriminant = b * b - a * c;
        if (a == 0 || discriminant < 0) return null;

        var root = Math.Sqrt(discriminant);
        var near = (-b - root) / a;
        if (ray.Counts(near) && IsOnTube(near)) return near;
        var far = (-b + root) / a;
        if (ray.Counts(far) && IsOnTube(far)) return far;
        return null;

        bool IsOnTube(double t) => Math.Abs(CP.Z + t * d.Z) <= height / 2;
    }
}
