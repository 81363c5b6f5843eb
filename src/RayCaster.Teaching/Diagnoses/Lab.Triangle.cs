using Crossed = RayCaster.Crossings<RayCaster.Scalar>;

namespace RayCaster.Teaching;

/// <summary>The triangle in the slide's steps, for mistakes in one of them; right as it stands here, but for rounding.</summary>
internal sealed partial class Lab
{
    private Func<Vector3, double> whole = n => n * n;
    private Func<double, double, bool> inside = (u, v) => u >= 0 && v >= 0 && u + v <= 1;

    /// <summary>Puts a formula in the place of the triangle's that may hit it outside of itself.</summary>
    public void TriangleIs(Func<Triangle, Vector3, Crossed> formula)
    {
        Triangle.Is(formula);
        TrianglesReachOut = true;
    }

    /// <summary>n = (B − A) × (C − A), u and v are shares of its length.</summary>
    /// <param name="whole">n → what u and v are divided by; as before if null.</param>
    /// <param name="inside">(u, v) → whether X is in the triangle; as before if null.</param>
    public void TriangleByShares(Func<Vector3, double>? whole = null, Func<double, double, bool>? inside = null)
    {
        this.whole = whole ?? this.whole;
        this.inside = inside ?? this.inside;
        TriangleIs((triangle, d) =>
        {
            var (A, B, C) = (triangle.A, triangle.B, triangle.C);
            var n = NormalOf(triangle);
            var t = (A - P) * n / (d * n);
            if (!Counts(t, d)) return SlideFormulas.None; // only to be done sooner
            var X = P + t * d;
            var all = this.whole(n);
            return this.inside(Cross.Do(A - C, X - C) * n / all, Cross.Do(B - A, X - A) * n / all) ? new(t) : SlideFormulas.None;
        });
    }

    /// <summary>(B − A) × (C − A).</summary>
    public Vector3 NormalOf(Triangle triangle) => Cross.Do(triangle.B - triangle.A, triangle.C - triangle.A);
}
