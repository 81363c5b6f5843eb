namespace Lab;

/// <summary>A triangle, seen from both sides whatever the order of its corners; its edges belong to it.</summary>
public class Triangle(Vector3 a, Vector3 b, Vector3 c) : Model
{
    public Vector3 A = a, B = b, C = c;

    public override void Intersect(Ray ray)
    {
        // BEGIN SOLUTION "Triangle"
        var d = ray.Direction;
        var n = (B - A) % (C - A);
        if (d * n == 0) return; // edge-on
        var t = (A - ray.Origin) * n / (d * n);

        // X = w A + u B + v C with w + u + v = 1. Seen from P, X − P = t d = w PA + u PB + v PC: three equations, for x, y and z. Cramer's rule
        // solves them: w, u and v are d·(PB × PC), d·(PC × PA) and d·(PA × PB), each divided by the same number. They add up to 1, so this number
        // is the sum of the three products.
        // The hand-out's formulas give the same u and v. Here two triangles that share an edge compute the same product for it, with opposite
        // signs: no ray passes between them. The slide's strict u > 0 would lose the rays through the edge itself: pinholes in every mesh.
        var (PA, PB, PC) = (A - ray.Origin, B - ray.Origin, C - ray.Origin);
        var (w, u, v) = (d * (PB % PC), d * (PC % PA), d * (PA % PB));
        var sum = w + u + v;
        if (u / sum >= 0 && v / sum >= 0 && w / sum >= 0) ray.Hit(t, this); // w ≥ 0 is u + v ≤ 1
        // END SOLUTION
    }
}
