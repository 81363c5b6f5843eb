namespace Lab;

/// <summary>A sphere, seen from outside or from inside.</summary>
public class Sphere(Vector3 center, double radius) : Model
{
    public Vector3 C = center;

    public double R = radius;

    /// <summary>The slides have two ways to the same crossings; pictures are drawn with this one.</summary>
    public override void Intersect(Ray ray) => GeometricSolution(ray);

    public void GeometricSolution(Ray ray)
    {
        // BEGIN SOLUTION "Sphere – Geometric Solution"
        var L = C - ray.Origin;
        var t_ca = L * ray.Direction;
        // The slide's "t_ca should be greater than zero" is right only for a camera outside the sphere: from inside, one sees the sphere even if
        // its centre lies behind.

        // The slide's Pythagoras, D² = L² − t_ca², subtracts two large, nearly equal numbers for a far sphere, so it loses digits, and
        // the sphere's edge moves. Here D is computed without that loss: it is the vector to C from the point of the ray that is nearest to C. Its
        // length is the slide's D.
        var D = L - t_ca * ray.Direction;
        if (D * D > R * R) return; // passes by
        var t_hc = Math.Sqrt(R * R - D * D); // the slide writes t_hc² on the left; the square is an error of the slide
        ray.Hit(t_ca - t_hc, this);
        ray.Hit(t_ca + t_hc, this); // this one shows if the near one does not count: the camera is inside, or zNear cuts the sphere open
        // END SOLUTION
    }

    public void AnalyticalSolution(Ray ray)
    {
        // BEGIN SOLUTION "Sphere – Analytical Solution"
        var CP = ray.Origin - C;
        var a = ray.Direction * ray.Direction; // 1, since d has length 1
        var b = 2 * (ray.Direction * CP);
        var c = CP * CP - R * R;
        var discriminant = b * b - 4 * a * c;
        if (discriminant < 0) return; // passes by; the root would be NaN
        ray.Hit((-b - Math.Sqrt(discriminant)) / (2 * a), this);
        ray.Hit((-b + Math.Sqrt(discriminant)) / (2 * a), this);
        // END SOLUTION
    }
}
