namespace RayCaster.Engine;

/// <summary>Clips the triangles that reach behind the eye or far off the picture into pieces that can be projected.</summary>
internal sealed class ScreenClipper
{
    private readonly ScreenSpace screen;
    private readonly Vector3[] vertices;
    private readonly Vector3[] planes; // a point p is on the inner side where p·n ≥ 0; the last is the eye's plane or the near one
    private readonly List<Vector128<float>> points = [];
    private readonly List<int> owners = [];
    private List<Vector3> polygon = [], clipped = [];

    public ScreenClipper(ScreenSpace screen, Vector3[] vertices)
    {
        (this.screen, this.vertices) = (screen, vertices);
        var camera = screen.Camera;
        double Slope(double pixel, double center) => (pixel - center) / screen.Scale;
        planes =
        [
            new(1, 0, -Slope(-screen.Guard, screen.CenterX)), new(-1, 0, Slope(camera.Width + screen.Guard, screen.CenterX)),
            new(0, 1, -Slope(-screen.Guard, screen.CenterY)), new(0, -1, Slope(camera.Height + screen.Guard, screen.CenterY)),
        ];
    }

    /// <summary>Triangles whose hits only the formula can find: three vertices for each.</summary>
    public List<int> FormulaOnly { get; } = [];

    /// <summary>The pieces, three points for each.</summary>
    public Vector128<float>[] Points => [.. points];

    /// <summary>The triangles that the pieces belong to.</summary>
    public int[] Owners => [.. owners];

    public void Add(int triangle, int cornerA, int cornerB, int cornerC)
    {
        var (a, b, c) = (screen.ToCamera(vertices[cornerA]), screen.ToCamera(vertices[cornerB]), screen.ToCamera(vertices[cornerC]));
        var size = Math.Max(Largest(a), Math.Max(Largest(b), Largest(c)));
        if (!(size is > 1e-90 and < 1e90))
        {
            AddFormulaOnly();
            return;
        }

        // Seen edge-on, the formula's weights are noise and its t may be any that the corners span, so a triangle behind the eye might be "hit"
        // before it. The volume over the triangle is t · area; beyond 1e-12 of its greatest value its sign, and t's, is safe, since it rounds by
        // some 1e-15.
        var (inFront, behind) = (Math.Min(a.Z, Math.Min(b.Z, c.Z)) > 1e-9 * size, Math.Max(a.Z, Math.Max(b.Z, c.Z)) < -1e-9 * size);
        var volume = Math.Abs(a % b * c) / (size * size * size);
        if (!inFront && volume < 1e-12)
        {
            AddFormulaOnly();
            return;
        }
        if (behind) return;
        foreach (var plane in planes)
            if (a * plane < 0 && b * plane < 0 && c * plane < 0) return; // the guard, hundreds of pixels, is margin enough
        if (volume < 1e-6)
        {
            AddFormulaOnly();
            return;
        }
        if (!Clip(a, b, c, size, triangle)) AddFormulaOnly();

        void AddFormulaOnly() => FormulaOnly.AddRange([cornerA, cornerB, cornerC]);
    }

    /// <summary>Clips a triangle whose t is accurate to 1e-8; false if the pieces would not be accurate.</summary>
    private bool Clip(Vector3 a, Vector3 b, Vector3 c, double size, int triangle)
    {
        polygon.Clear();
        polygon.AddRange([a, b, c]);
        foreach (var plane in planes) ClipBy(plane, 0);
        ClipBy(new(0, 0, 1), screen.MinDepth);
        if (polygon.Count < 3) return true;

        // A cut is exact to some units of 2⁻⁵³ of the whole triangle, which near the eye may be many pixels.
        var nearest = double.PositiveInfinity;
        foreach (var p in polygon) nearest = Math.Min(nearest, p.Z);
        if (!(screen.DoubleMargin * size < 0.2 * screen.Margin * nearest)) return false;

        var first = points.Count;
        foreach (var p in polygon)
        {
            var (x, y, w) = screen.Project<Scalar>(p.X, p.Y, p.Z);
            if (!screen.IsFit(x, y, w))
            {
                points.RemoveRange(first, points.Count - first);
                return false;
            }
            points.Add(Vector128.Create((float)(double)x, (float)(double)y, (float)(double)w, 0));
        }
        var corners = points[first..];
        points.RemoveRange(first, corners.Count);
        for (var i = 2; i < corners.Count; i++)
        {
            points.AddRange([corners[0], corners[i - 1], corners[i]]);
            owners.Add(triangle);
        }
        return true;
    }

    /// <summary>Keeps what is on the inner side of a plane (Sutherland, Hodgman, "Reentrant Polygon Clipping", 1974).</summary>
    private void ClipBy(Vector3 plane, double least)
    {
        clipped.Clear();
        for (var i = 0; i < polygon.Count; i++)
        {
            var (p, q) = (polygon[i], polygon[(i + 1) % polygon.Count]);
            var (inP, inQ) = (p * plane - least, q * plane - least);
            if (inP >= 0) clipped.Add(p);
            if (inP >= 0 != inQ >= 0) clipped.Add(p + inP / (inP - inQ) * (q - p));
        }
        (polygon, clipped) = (clipped, polygon);
    }

    private static double Largest(Vector3 p) => Math.Max(Math.Abs(p.X), Math.Max(Math.Abs(p.Y), Math.Abs(p.Z)));
}
