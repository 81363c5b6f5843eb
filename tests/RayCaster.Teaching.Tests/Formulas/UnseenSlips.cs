namespace RayCaster.Teaching.Tests.Formulas;

/// <summary>
/// Sixty slips that were written down from the slides by somebody who did not know the operators, before any of them was tried. No operator and no
/// cost was chosen by them: who tunes by them must plant others to measure.
/// </summary>
internal static class UnseenSlips
{
    /// <param name="Section">The step in which it is made.</param>
    /// <param name="Formulas">What the formula computes, as the steps' styles call it.</param>
    public sealed record Slip(string Section, string Formulas, string What, params SourceEdit[] Edits);

    public static readonly Slip[] All =
    [
        new("vectors", "cross", "a × b, x = ay bz + az by", new SourceEdit("Vector3", "a.Y * b.Z - a.Z * b.Y", "a.Y * b.Z + a.Z * b.Y")),
        new("vectors", "times", "b a, x for y", new SourceEdit("Vector3", "b * a.Y, b * a.Z)", "b * a.X, b * a.Z)")),
        new("vectors", "dot", "a·b = ax bx + ay by + az bx", new SourceEdit("Vector3", "a.Z * b.Z;", "a.Z * b.X;")),
        new("vectors", "length", "|a| = |x| + |y| + |z|", new SourceEdit("Vector3", "Math.Sqrt(this * this)", "Math.Abs(X) + Math.Abs(Y) + Math.Abs(Z)")),
        new("vectors", "normalize", "a / |a|²", new SourceEdit("Vector3", "=> this / Length;", "=> this / (this * this);")),
        new("camera", "W", "W = (−T − P) normalised", new SourceEdit("Camera", "-(Target - Position).Normalized", "(-Target - Position).Normalized")),
        new("camera", "U", "U = (T × W) normalised", new SourceEdit("Camera", "(Up % W)", "(Target % W)")),
        new("camera", "V", "V = U × (T − P), not normalised", new SourceEdit("Camera", "V = W % U;", "V = U % (Target - Position);")),
        new("camera", "h", "h = 2 tan(fovY / 2) π / 180, fovY in degrees",
            new SourceEdit("Camera", "Math.Tan(fovY / 2 * Math.PI / 180)", "Math.Tan(fovY / 2) * Math.PI / 180")),
        new("camera", "h angle", "fovY π / 360, a whole turn", new SourceEdit("Camera", "Math.PI / 180", "Math.PI / 360")),
        new("camera", "h", "h = 2 / tan(fovY / 2)", new SourceEdit("Camera", "2 * Math.Tan(fovY", "2 / Math.Tan(fovY")),
        new("camera", "h", "h = 2 |T − P| tan(fovY / 2)",
            new SourceEdit("Camera", "h = 2 * Math.Tan(fovY", "h = 2 * (Target - Position).Length * Math.Tan(fovY")),
        new("camera", "w", "w = h width / 2 height", new SourceEdit("Camera", "h * Width / Height;", "h * Width / (2 * Height);")),
        new("pixel", "ur", "ur = h r / height + h / 2", new SourceEdit("Camera", "Height - h / 2", "Height + h / 2")),
        new("pixel", "uc", "uc = c / width − w / 2", new SourceEdit("Camera", "w * c / Width", "c / Width")),
        new("pixel", "uc", "uc = w c / width − 1 / 2", new SourceEdit("Camera", "Width - w / 2", "Width - 1 / 2.0")),
        new("pixel", "ur", "ur = h c / height − h / 2", new SourceEdit("Camera", "h * r / Height", "h * c / Height")),
        new("pixel", "d", "d = uc U + ur V − P", new SourceEdit("Camera", "ur * V - W", "ur * V - Position")),
        new("pixel", "d", "d = (uc U + ur V) normalised − W",
            new SourceEdit("Camera", "(uc * U + ur * V - W).Normalized", "(uc * U + ur * V).Normalized - W")),
        new("plane", "t", "t = −P·n / d·n", new SourceEdit("Plane", "(Q - ray.Origin) * n", "-ray.Origin * n")),
        new("plane", "t", "t = (Q − P)·n / d·Q", new SourceEdit("Plane", "/ (ray.Direction * n)", "/ (ray.Direction * Q)")),
        new("plane", "t", "t = (Q − d)·n / d·n", new SourceEdit("Plane", "(Q - ray.Origin) * n", "(Q - ray.Direction) * n")),
        new("plane", "t", "t = |(Q − P) × n| / d·n", new SourceEdit("Plane", "(Q - ray.Origin) * n", "((Q - ray.Origin) % n).Length")),
        new("circle", "hit", "|X − C| ≤ R / 2, R for the diameter", new SourceEdit("Circle", "<= R", "<= R / 2")),
        new("circle", "hit", "(x − Cx)² + (y − Cy)² − (z − Cz)² ≤ R²",
            new SourceEdit("Circle", "(X - C).Length <= R",
                "(X.X - C.X) * (X.X - C.X) + (X.Y - C.Y) * (X.Y - C.Y) - (X.Z - C.Z) * (X.Z - C.Z) <= R * R")),
        new("circle", "hit", "X² − C² ≤ R²", new SourceEdit("Circle", "(X - C).Length <= R", "X * X - C * C <= R * R")),
        new("circle", "hit", "|x − Cx| ≤ R, |y − Cy| ≤ R, |z − Cz| ≤ R, as for a box",
            new SourceEdit("Circle", "(X - C).Length <= R", "Math.Abs(X.X - C.X) <= R && Math.Abs(X.Y - C.Y) <= R && Math.Abs(X.Z - C.Z) <= R")),
        new("circle", "hit", "(x − Cx)² + (y − Cy)² + (z − Cz) ≤ R²",
            new SourceEdit("Circle", "(X - C).Length <= R", "(X.X - C.X) * (X.X - C.X) + (X.Y - C.Y) * (X.Y - C.Y) + (X.Z - C.Z) <= R * R")),
        new("sphere", "t_hc", "t_hc = R² − D², no root", new SourceEdit("Sphere", "Math.Sqrt(R * R - D * D)", "R * R - D * D")),
        new("sphere", "L O t_ca", "L = C, without P", new SourceEdit("Sphere", "L = C - ray.Origin", "L = C")),
        new("sphere", "t_hc", "t_hc = √R² − D², the root of R² only", new SourceEdit("Sphere", "Math.Sqrt(R * R - D * D)", "Math.Sqrt(R * R) - D * D")),
        new("sphere", "t", "t = t_ca − |D|", new SourceEdit("Sphere", "t_ca - t_hc", "t_ca - D.Length")),
        new("sphere", "D2 D M", "D = L − d", new SourceEdit("Sphere", "L - t_ca * ray.Direction;", "L - ray.Direction;")),
        new("sphere", "t_ca", "t_ca = L·d / |L|", new SourceEdit("Sphere", "L * ray.Direction;", "L * ray.Direction / L.Length;")),
        new("sphere", "c", "c = P² − C² − R²", PlantedMistake.Analytical, new SourceEdit("Sphere", "CP * CP - R * R", "ray.Origin * ray.Origin - C * C - R * R")),
        new("sphere", "b", "b = (P − C)·d", PlantedMistake.Analytical, new SourceEdit("Sphere", "2 * (ray.Direction * CP)", "ray.Direction * CP")),
        new("sphere", "t", "t = (−b ∓ √D) / a", PlantedMistake.Analytical,
            new("Sphere", "(-b - Math.Sqrt(discriminant)) / (2 * a)", "(-b - Math.Sqrt(discriminant)) / a"),
            new("Sphere", "(-b + Math.Sqrt(discriminant)) / (2 * a)", "(-b + Math.Sqrt(discriminant)) / a")),
        new("sphere", "disc discriminant D", "D = b² − 2 a c", PlantedMistake.Analytical, new SourceEdit("Sphere", "b * b - 4 * a", "b * b - 2 * a")),
        new("aabb", "tmin tmin1", "tmin = max(x0, min(y0, z0))", new SourceEdit("Aabb", "Math.Max(y0, z0)", "Math.Min(y0, z0)")),
        new("aabb", "tmax tmax1", "tmax = max(x1, y1, z1)", new SourceEdit("Aabb", "Math.Min(x1, Math.Min(y1, z1))", "Math.Max(x1, Math.Max(y1, z1))")),
        new("aabb", "hit", "tmin > tmax never tested", new SourceEdit("Aabb", "if (t_min > t_max) return;", "")),
        new("aabb", "t1 t1x t1y t1z", "t1 = (B1 − B0) / d", new SourceEdit("Aabb", "t1 = (B1 - P) / d", "t1 = (B1 - B0) / d")),
        new("aabb", "t0 t1 t0x t0y t0z t1x t1y t1z", "(B − P) / |d| for each slab",
            new SourceEdit("Aabb", "t0 = (B0 - P) / d", "t0 = (B0 - P) / Math.Abs(d)"),
            new SourceEdit("Aabb", "t1 = (B1 - P) / d", "t1 = (B1 - P) / Math.Abs(d)")),
        new("aabb", "t1 t1y", "B1.x for B1.y", new SourceEdit("Aabb", "B1.Y, P.Y", "B1.X, P.Y")),
        new("aabb", "t0 t1 t0z t1z", "d.x for d.z", new SourceEdit("Aabb", "P.Z, d.Z", "P.Z, d.X")),
        new("triangle", "n", "n = B − A × C − A, no brackets", new SourceEdit("Triangle", "(B - A) % (C - A)", "B - A % C - A")),
        new("triangle", "u", "u = d·(a × c)", new SourceEdit("Triangle", "(c % a)", "(a % c)")),
        new("triangle", "s", "s = P − B", SourceEdit.OfTriangle("""
            var (e1, e2, s, d) = (B - A, C - A, ray.Origin - B, ray.Direction);
            var (p, q) = (d % e2, s % e1);
            var det = e1 * p;
            var (u, v, t) = (s * p / det, d * q / det, e2 * q / det);
            if (u >= 0 && v >= 0 && u + v <= 1) ray.Hit(t, this);
            """)),
        new("triangle", "v", "v = s·q / det", SourceEdit.OfTriangle("""
            var (e1, e2, s, d) = (B - A, C - A, ray.Origin - A, ray.Direction);
            var (p, q) = (d % e2, s % e1);
            var det = e1 * p;
            var (u, v, t) = (s * p / det, s * q / det, e2 * q / det);
            if (u >= 0 && v >= 0 && u + v <= 1) ray.Hit(t, this);
            """)),
        new("triangle", "hit", "c1·c2 ≥ 0, the third edge never tested", SourceEdit.OfTriangle("""
            var (d, n) = (ray.Direction, (B - A) % (C - A));
            var t = (A - ray.Origin) * n / (d * n);
            var X = ray.At(t);
            var (c1, c2, c3) = ((B - A) % (X - A), (C - B) % (X - B), (A - C) % (X - C));
            if (c1 * c2 >= 0) ray.Hit(t, this);
            """)),
        new("triangle", "hit", "n·((C − A) × (X − C)) ≥ 0, the last edge turned round", SourceEdit.OfTriangle("""
            var (d, n) = (ray.Direction, (B - A) % (C - A));
            var t = (A - ray.Origin) * n / (d * n);
            var X = ray.At(t);
            if (n * ((B - A) % (X - A)) >= 0 && n * ((C - B) % (X - B)) >= 0 && n * ((C - A) % (X - C)) >= 0) ray.Hit(t, this);
            """)),
        new("triangle", "S hit", "the second area twice, the third never", SourceEdit.OfTriangle("""
            var (d, n) = (ray.Direction, (B - A) % (C - A));
            var t = (A - ray.Origin) * n / (d * n);
            var X = ray.At(t);
            var S = ((B - X) % (C - X)).Length / 2 + ((C - X) % (A - X)).Length / 2 + ((C - X) % (A - X)).Length / 2;
            if (S <= n.Length / 2 + 1e-6) ray.Hit(t, this);
            """)),
        new("rule", "z", "z = t (−d·W) − zNear", new SourceEdit("Ray", "t * DepthPerT;", "t * DepthPerT - ZNear;")),
        new("rule", "hit", "z compared with the t of the nearest hit", new SourceEdit("Ray", "|| t >= HitParameter", "|| t * DepthPerT >= HitParameter")),
        new("rule", "hit", "the first model that is hit stays", new SourceEdit("Ray", "|| t >= HitParameter", "|| HitModel != null")),
        new("light", "att", "1 − t / 2 |T + P|", new SourceEdit("Camera", "(2 * (Target - Position))", "(2 * (Target + Position))")),
        new("light", "att", "1 − |X − T| / 2 |T − P|",
            new SourceEdit("Camera", "1 - ray.HitParameter /", "1 - (ray.At(ray.HitParameter) - Target).Length /")),
        new("light", "att", "1 − t / zFar", new SourceEdit("Camera", "ray.HitParameter / (2 * (Target - Position)).Length", "ray.HitParameter / ZFar")),
        new("bytes", "rgb", "255 channel²", new SourceEdit("Color", "Math.Clamp(channel, 0, 1) * 255", "Math.Clamp(channel * channel, 0, 1) * 255")),
        new("bytes", "rgb", "255 (channel + 1) / 2",
            new SourceEdit("Color", "Math.Clamp(channel, 0, 1) * 255", "(Math.Clamp(channel, 0, 1) + 1) / 2 * 255")),
    ];
}
