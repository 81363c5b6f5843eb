namespace RayCaster.Teaching.Tests.Formulas;

/// <summary>
/// A small ray caster written from the slides, without the project's formulas, that makes one of some sixty slips which the catalogue of known
/// mistakes does not have.
/// </summary>
/// <param name="slip">A place in <see cref="All"/>; −1 for none.</param>
internal sealed class PlantedSlips(Scene scene, int slip)
{
    /// <summary>The step in which each slip is made, the names of the formulas that may be blamed for it, and what is written.</summary>
    public static readonly (string Section, string Formulas, string What)[] All =
    [
        ("camera", "W", "W = −(T − P) / |T|"),
        ("camera", "V", "V = W × up, not normalised"),
        ("camera", "angle h", "fovY·π / 200"),
        ("camera", "h", "h = 2 sin(fovY / 2)"),
        ("camera", "aspect w", "w = h √(width / height)"),
        ("camera", "aspect w", "w = h (width / height)²"),
        ("camera", "aspect w", "w = h width / (height − 100)"),
        ("camera", "h", "h = 2 tan(fovY / 2)²"),
        ("pixel", "uc", "uc = w c / width − h / 2"),
        ("pixel", "ur", "ur = h r / height − w / 2"),
        ("pixel", "uc", "uc = w c / height − w / 2"),
        ("pixel", "uc", "uc = w c / width − w / 4"),
        ("pixel", "d", "d = uc U + ur V − 2 W"),
        ("pixel", "d", "d = uc U + ur U − W"),
        ("pixel", "d ur", "d = uc U + uc V − W"),
        ("file", "r", "r = height / 2 − y"),
        ("plane", "den t", "t = (Q − P)·n / d·d"),
        ("plane", "t", "t = (Q − P)·n · (d·n)"),
        ("plane", "t", "t = |(Q − P)·n / d·n|"),
        ("plane", "t", "t = (Q − T)·n / d·n"),
        ("sphere", "L", "L = C − T"),
        ("sphere", "tca", "tca = L·d / 2"),
        ("sphere", "D2 D", "D² = L² − 2 tca²"),
        ("sphere", "thc", "thc = √(2 R² − D²)"),
        ("sphere", "hit", "t = (b ± √D) / 2 a, the sign of b lost"),
        ("sphere", "D", "D = b² + 4 a c"),
        ("sphere", "hit", "t = tca − thc / 2"),
        ("sphere", "L O tca", "L = C − d"),
        ("aabb", "t0x t0 t1 t1x", "(B − P) d for each slab"),
        ("aabb", "t0y", "B1.y for B0.y"),
        ("aabb", "t0x t1x", "d.y for d.x"),
        ("aabb", "t0z t1z", "P.y for P.z"),
        ("aabb", "t0x t0 t1 t1x", "(B − T) / d for each slab"),
        ("aabb", "hit", "t = (tmin + tmax) / 2"),
        ("aabb", "tmin", "tmin = max(x, y, −z)"),
        ("circle", "hit", "|X| ≤ R"),
        ("circle", "hit", "|X − P| ≤ R"),
        ("circle", "hit", "|X − C| ≤ √R"),
        ("circle", "X", "X = P + d"),
        ("circle", "t", "t = (P − C)·n / d·n"),
        ("triangle", "e2", "C − B for C − A"),
        ("triangle", "hit", "u v ≤ 1"),
        ("triangle", "hit", "u + v ≤ ½"),
        ("triangle", "n", "n = B × C"),
        ("triangle", "t", "t = e1·q / det"),
        ("triangle", "hit", "u − v ≤ 1"),
        ("triangle", "u v", "u = s·p, not divided"),
        ("rule", "z", "z = t² (−d·W)"),
        ("rule", "hit", "z ≤ zFar / 2"),
        ("rule", "hit", "z ≥ zFar for z ≥ zNear"),
        ("light", "att", "1 − t / |T − P|²"),
        ("light", "att", "1 − t / 2 |T|"),
        ("light", "att", "1 − t / 2 |P|"),
        ("light", "att", "1 − √t / 2 |T − P|"),
        ("light", "att", "1 − (t / 2 |T − P|)²"),
        ("light", "att", "not below ½"),
        ("light", "att", "1 − 2 t / |T − P|"),
        ("bytes", "rgb", "128 colour"),
        ("bytes", "rgb", "√colour"),
        ("bytes", "rgb", "clamped at ½"),
    ];

    private readonly int slip = slip;
    private Vector3 P, T, W, U, V;
    private double w, h;

    public Picture Draw()
    {
        var camera = scene.Camera;
        (P, T) = (camera.Position, camera.Target);
        var (width, height) = ((double)camera.Width, (double)camera.Height);
        W = Is("W = −(T − P) / |T|") ? -(T - P) / T.Length : -(T - P) / (T - P).Length;
        U = Cross(camera.Up, W).Normalized;
        V = Is("V = W × up, not normalised") ? Cross(W, camera.Up) : Cross(W, U);
        var half = camera.FovY * Math.PI / (Is("fovY·π / 200") ? 200 : 180) / 2;
        h = 2 * (Is("h = 2 sin(fovY / 2)") ? Math.Sin(half) : Is("h = 2 tan(fovY / 2)²") ? Math.Tan(half) * Math.Tan(half) : Math.Tan(half));
        var aspect = width / (Is("w = h width / (height − 100)") ? height - 100 : height);
        w = h * (Is("w = h √(width / height)") ? Math.Sqrt(aspect) : Is("w = h (width / height)²") ? aspect * aspect : aspect);
        var offset = camera.Sample == PixelSample.Center ? 0.5 : 0;
        var picture = new Picture(camera.Width, camera.Height);
        for (var y = 0; y < camera.Height; y++)
        {
            for (var x = 0; x < camera.Width; x++)
            {
                var (c, r) = (x + offset, (Is("r = height / 2 − y") ? height / 2 : height - 1) - y + offset);
                var uc = w * c / (Is("uc = w c / height − w / 2") ? height : width)
                    - (Is("uc = w c / width − h / 2") ? h / 2 : Is("uc = w c / width − w / 4") ? w / 4 : w / 2);
                var ur = h * r / height - (Is("ur = h r / height − w / 2") ? w / 2 : h / 2);
                var up = (Is("d = uc U + uc V − W") ? uc : ur) * (Is("d = uc U + ur U − W") ? U : V);
                var d = uc * U + up - (Is("d = uc U + ur V − 2 W") ? 2 : 1) * W;
                picture[x, y] = Cast(d / d.Length);
            }
        }
        return picture;
    }

    private bool Is(string what) => slip >= 0 && All[slip].What == what;

    private (byte, byte, byte) Cast(Vector3 d)
    {
        var (camera, best, color) = (scene.Camera, double.PositiveInfinity, scene.Background);
        Model? hit = null;
        foreach (var model in scene.Models)
        {
            foreach (var t in Crossings(model, d))
            {
                var depth = t * -Dot(d, W);
                if (Is("z = t² (−d·W)")) depth *= t;
                if (camera.Clip == ClipMode.Distance) depth = t;
                var far = Is("z ≤ zFar / 2") ? camera.ZFar / 2 : camera.ZFar;
                var near = Is("z ≥ zFar for z ≥ zNear") ? camera.ZFar : camera.ZNear;
                if (!(t > camera.Bias && depth >= near && depth <= far)) continue;
                if (t < best) (best, hit) = (t, model);
                break;
            }
        }
        var light = 1.0;
        if (hit is not null)
        {
            var share = best / (2 * (T - P).Length);
            if (Is("1 − t / |T − P|²")) share = best / Dot(T - P, T - P);
            if (Is("1 − t / 2 |T|")) share = best / (2 * T.Length);
            if (Is("1 − t / 2 |P|")) share = best / (2 * P.Length);
            if (Is("1 − √t / 2 |T − P|")) share = Math.Sqrt(best) / (2 * (T - P).Length);
            if (Is("1 − (t / 2 |T − P|)²")) share *= share;
            if (Is("1 − 2 t / |T − P|")) share = 2 * best / (T - P).Length;
            light = Math.Max(Is("not below ½") ? 0.5 : 0, 1 - share);
            color = hit.Color;
        }
        return (Level(light * color.R), Level(light * color.G), Level(light * color.B));
    }

    private byte Level(double channel)
    {
        if (Is("√colour")) channel = Math.Sqrt(channel);
        var cut = Math.Clamp(channel, 0, Is("clamped at ½") ? 0.5 : 1);
        return (byte)((Is("128 colour") ? 128 : 255) * cut + 0.5);
    }

    private IEnumerable<double> Crossings(Model model, Vector3 d) => model switch
    {
        Model<Plane> { Primitive: var p } => OnPlane(p.Point, p.Normal, d),
        Model<Sphere> { Primitive: var s } => OnSphere(s.Center, s.Radius, d),
        Model<Aabb> { Primitive: var b } => OnBox(b.Min, b.Max, d),
        Model<Circle> { Primitive: var c } => OnCircle(c.Center, c.Normal, c.Radius, d),
        Model<Triangle> { Primitive: var t } => OnTriangle(t.A, t.B, t.C, d),
        _ => throw new NotSupportedException(),
    };

    private double[] OnPlane(Vector3 Q, Vector3 n, Vector3 d)
    {
        var (up, den) = (Dot(Q - (Is("t = (Q − T)·n / d·n") ? T : P), n), Is("t = (Q − P)·n / d·d") ? Dot(d, d) : Dot(d, n));
        var t = Is("t = (Q − P)·n · (d·n)") ? up * den : up / den;
        return [Is("t = |(Q − P)·n / d·n|") ? Math.Abs(t) : t];
    }

    private double[] OnSphere(Vector3 C, double R, Vector3 d)
    {
        if (All[Math.Max(0, slip)].What is "t = (b ± √D) / 2 a, the sign of b lost" or "D = b² + 4 a c")
        {
            var (o, a) = (P - C, Dot(d, d));
            var (b, c) = (2 * Dot(o, d), Dot(o, o) - R * R);
            var D = Is("D = b² + 4 a c") ? b * b + 4 * a * c : b * b - 4 * a * c;
            if (!Is("D = b² + 4 a c")) b = -b;
            return D < 0 ? [] : [(-b - Math.Sqrt(D)) / (2 * a), (-b + Math.Sqrt(D)) / (2 * a)];
        }
        var L = C - (Is("L = C − T") ? T : Is("L = C − d") ? d : P);
        var tca = Dot(L, d) / (Is("tca = L·d / 2") ? 2 : 1);
        var D2 = Dot(L, L) - (Is("D² = L² − 2 tca²") ? 2 : 1) * tca * tca;
        var thc2 = (Is("thc = √(2 R² − D²)") ? 2 : 1) * R * R - D2;
        if (thc2 < 0) return [];
        var thc = Math.Sqrt(thc2);
        return [tca - thc / (Is("t = tca − thc / 2") ? 2 : 1), tca + thc];
    }

    private double[] OnBox(Vector3 B0, Vector3 B1, Vector3 d)
    {
        var from = Is("(B − T) / d for each slab") ? T : P;
        var (x0, x1) = (Over(B0.X - from.X, Is("d.y for d.x") ? d.Y : d.X), Over(B1.X - from.X, Is("d.y for d.x") ? d.Y : d.X));
        var (y0, y1) = (Over((Is("B1.y for B0.y") ? B1.Y : B0.Y) - from.Y, d.Y), Over(B1.Y - from.Y, d.Y));
        var z = Is("P.y for P.z") ? from.Y : from.Z;
        var (z0, z1) = (Over(B0.Z - z, d.Z), Over(B1.Z - z, d.Z));
        var zIn = Math.Min(z0, z1);
        var tmin = Math.Max(Math.Min(x0, x1), Math.Max(Math.Min(y0, y1), Is("tmin = max(x, y, −z)") ? -zIn : zIn));
        var tmax = Math.Min(Math.Max(x0, x1), Math.Min(Math.Max(y0, y1), Math.Max(z0, z1)));
        return tmin > tmax ? [] : Is("t = (tmin + tmax) / 2") ? [(tmin + tmax) / 2] : [tmin, tmax];

        double Over(double way, double along) => Is("(B − P) d for each slab") ? way * along : way / along;
    }

    private double[] OnCircle(Vector3 C, Vector3 n, double R, Vector3 d)
    {
        var t = Dot(Is("t = (P − C)·n / d·n") ? P - C : C - P, n) / Dot(d, n);
        var X = Is("X = P + d") ? P + d : P + t * d;
        var distance = (Is("|X| ≤ R") ? X : Is("|X − P| ≤ R") ? X - P : X - C).Length;
        return distance <= (Is("|X − C| ≤ √R") ? Math.Sqrt(R) : R) ? [t] : [];
    }

    private double[] OnTriangle(Vector3 A, Vector3 B, Vector3 C, Vector3 d)
    {
        if (Is("n = B × C"))
        {
            var n = Cross(B, C);
            var at = Dot(A - P, n) / Dot(d, n);
            var X = P + at * d;
            return Beside(A, B) && Beside(B, C) && Beside(C, A) ? [at] : [];

            bool Beside(Vector3 a, Vector3 b) => Dot(n, Cross(b - a, X - a)) >= 0;
        }
        var (e1, e2, s) = (B - A, C - (Is("C − B for C − A") ? B : A), P - A);
        var (p, q) = (Cross(d, e2), Cross(s, e1));
        var det = Dot(e1, p);
        var (u, v, t) = (Dot(s, p) / det, Dot(d, q) / det, Dot(Is("t = e1·q / det") ? e1 : e2, q) / det);
        if (Is("u = s·p, not divided")) u *= det;
        var last = Is("u v ≤ 1") ? u * v <= 1 : Is("u − v ≤ 1") ? u - v <= 1 : u + v <= (Is("u + v ≤ ½") ? 0.5 : 1);
        return u >= 0 && v >= 0 && last ? [t] : [];
    }

    private static double Dot(Vector3 a, Vector3 b) => a.X * b.X + a.Y * b.Y + a.Z * b.Z;

    private static Vector3 Cross(Vector3 a, Vector3 b) => new(a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X);
}
