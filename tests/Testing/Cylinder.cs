namespace RayCaster.Testing;

/// <summary>An upright tube without lids, written as docs/adding-a-primitive.md shows it: plain doubles and ifs, no number type.</summary>
public sealed class Cylinder(Vector3 center, double radius, double height) : Model
{
    public override double? Intersect(Ray ray)
    {
        var (P, d) = (ray.Origin - center, ray.Direction);

        // |X(t)| = R in the xy plane: a t² + 2 b t + c = 0
        var a = d.X * d.X + d.Y * d.Y;
        var b = P.X * d.X + P.Y * d.Y;
        var c = P.X * P.X + P.Y * P.Y - radius * radius;
        var discriminant = b * b - a * c;
        if (a == 0 || discriminant < 0) return null;

        var root = Math.Sqrt(discriminant);
        var near = (-b - root) / a;
        if (ray.Counts(near) && IsOnTube(near)) return near;
        var far = (-b + root) / a;
        if (ray.Counts(far) && IsOnTube(far)) return far;
        return null;

        bool IsOnTube(double t) => Math.Abs(P.Z + t * d.Z) <= height / 2;
    }
}
