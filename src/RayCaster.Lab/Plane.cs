namespace Lab;

/// <summary>An infinite plane, seen from both sides.</summary>
public class Plane(Vector3 point, Vector3 normal) : Model
{
    public Vector3 Q = point; // any point of the plane

    public Vector3 n = normal; // of any length: it cancels in t

    public override void Intersect(Ray ray)
    {
        // BEGIN SOLUTION "Ray – Plane Intersection"
        if (ray.Direction * n == 0) return; // parallel
        var t = (Q - ray.Origin) * n / (ray.Direction * n);
        ray.Hit(t, this);
        // END SOLUTION
    }
}
