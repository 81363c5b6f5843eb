namespace Lab;

/// <summary>A flat disc, seen from both sides; its rim belongs to it.</summary>
public class Circle(Vector3 center, Vector3 normal, double radius) : Model
{
    public Vector3 C = center, n = normal;

    public double R = radius;

    public override void Intersect(Ray ray)
    {
        // BEGIN SOLUTION "Circle"
        if (ray.Direction * n == 0) return; // parallel
        var t = (C - ray.Origin) * n / (ray.Direction * n);
        var X = ray.At(t);
        if ((X - C).Length <= R) ray.Hit(t, this);
        // END SOLUTION
    }
}
