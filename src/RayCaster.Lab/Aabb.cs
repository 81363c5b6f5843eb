namespace Lab;

/// <summary>A box with its sides along the axes.</summary>
public class Aabb(Vector3 min, Vector3 max) : Model
{
    public Vector3 B0 = min, B1 = max; // the corners with the least and the greatest coordinates

    public override void Intersect(Ray ray)
    {
        // BEGIN SOLUTION "AABB checking for intersection"
        var (P, d) = (ray.Origin, ray.Direction);
        var (x0, x1) = Slab(B0.X, B1.X, P.X, d.X);
        var (y0, y1) = Slab(B0.Y, B1.Y, P.Y, d.Y);
        var (z0, z1) = Slab(B0.Z, B1.Z, P.Z, d.Z);
        var t_min = Math.Max(x0, Math.Max(y0, z0)); // enters the last slab
        var t_max = Math.Min(x1, Math.Min(y1, z1)); // leaves the first slab
        if (t_min > t_max) return;
        ray.Hit(t_min, this);
        ray.Hit(t_max, this); // this one shows if t_min does not count: the camera is in the box, or zNear cuts it open
        // END SOLUTION
    }

    /// <summary>Where the ray enters and leaves the space B0 ≤ coordinate ≤ B1 along one axis: (t in, t out). If it never does: (+∞, −∞), so that
    /// t_min > t_max. The parameters are the coordinates of B0, B1, P and d along that axis.</summary>
    public static (double, double) Slab(double B0, double B1, double P, double d)
    {
        // BEGIN SOLUTION "AABB – intersection parameters"
        // STUB return Todo.Note("AABB – intersection parameters", (1.0, 0.0));
        if (d == 0) // parallel to the slab: all of the ray is in it, or none. On its face (B0 − P) / d is 0 / 0; the face belongs to the box.
            return B0 <= P && P <= B1
                ? (double.NegativeInfinity, double.PositiveInfinity)
                : (double.PositiveInfinity, double.NegativeInfinity);
        var t0 = (B0 - P) / d;
        var t1 = (B1 - P) / d;
        return t0 <= t1 ? (t0, t1) : (t1, t0); // if d < 0, B1 comes first
        // END SOLUTION
    }
}
