namespace RayCaster.Teaching.Tests.Diagnoses;

/// <summary>
/// A small ray caster written from the slides, without the project's formulas, that makes one of sixty mistakes of the catalogue, many of
/// them not in the wording that the catalogue draws.
/// </summary>
/// <param name="made">A mistake of <see cref="All"/>; null for none.</param>
internal sealed class OtherWordings(Scene scene, string? made)
{
    /// <summary>The ids that are right, the step, and what is written.</summary>
    public static readonly (string Ids, string Section, string What)[] All =
    [
        ("w-sign", "camera", "W = (T − P) / |T − P|"),
        ("t-dir", "camera", "W = −T / |T|"),
        ("t-dir", "camera", "W = P / |P|"),
        ("u-cross", "camera", "U = W × up"),
        ("v-cross", "camera", "V = U × W"),
        ("v-up", "camera", "V = up"),
        ("v-up", "camera", "V = up × U"),
        ("rad", "camera", "tan(fovY / 2) in degrees"),
        ("rad", "camera", "fovY · π, without / 180"),
        ("rad", "camera", "fovY / 180, without π"),
        ("nohalf", "camera", "h = 2 tan(fovY)"),
        ("nohalf no2", "camera", "h = tan(fovY)"),
        ("no2", "camera", "h = tan(fovY / 2)"),
        ("no2", "camera", "h = 4 tan(fovY / 2)"),
        ("no-tan", "camera", "h = 2 sin(fovY / 2)"),
        ("aspect-inv", "camera", "w = h · height / width"),
        ("aspect-none", "camera", "w = h"),
        ("fov-horiz", "camera", "w = 2 tan(fovY / 2), h = w · height / width"),
        ("u-unnorm", "camera", "U not normalised"),
        ("w-unnorm", "camera", "W not normalised"),
        ("no-center", "pixel", "uc without − w / 2"),
        ("no-center", "pixel", "− w and − h"),
        ("no-center", "pixel", "+ h / 2"),
        ("size-mixed", "pixel", "c / height and r / width"),
        ("size-mixed", "pixel", "ur = h r / width − h / 2"),
        ("uv-swap", "pixel", "uc V + ur U"),
        ("uv-swap", "pixel", "ur U + ur V"),
        ("dir-plus-w", "pixel", "uc U + ur V + W"),
        ("wm1", "pixel", "c / (width − 1)"),
        ("rows", "file", "r = y"),
        ("row-off", "file", "r = height − y"),
        ("plane-no-p", "plane", "plane: Q·n / d·n"),
        ("plane-sign", "plane", "plane: (P − Q)·n / d·n"),
        ("plane-sign", "plane", "plane: (Q − P)·n"),
        ("circ-nosq", "circle", "circle: |X − C|² ≤ R"),
        ("circ-nosq", "circle", "circle: |X − C| ≤ R²"),
        ("circ-inf", "circle", "circle: the radius not tested"),
        ("plane-no-p circ-inf", "circle", "circle: X = t d"),
        ("r-diameter", "circle", "circle: R / 2"),
        ("r-nosq", "sphere", "sphere: √(R − D²), and D² > R asked"),
        ("d-nosq", "sphere", "sphere: √(R² − D)"),
        ("d-nosq", "sphere", "sphere: D² = L² + t_ca²"),
        ("thc-nosqrt", "sphere", "sphere: t_hc = R² − D²"),
        ("thc-nosqrt", "sphere", "sphere: t_hc = R"),
        ("far-root", "sphere", "sphere: t_ca + t_hc"),
        ("oc-sign", "sphere", "sphere: L = P − C"),
        ("disc-2", "sphere", "sphere: b² − ac, b = 2 d·O"),
        ("disc-2", "sphere", "sphere: / a for / 2a"),
        ("plane-no-p", "sphere", "sphere: L = C"),
        ("r-diameter", "sphere", "sphere: 2 R"),
        ("slab-minmin", "aabb", "box: tmin = min"),
        ("slab-minmin", "aabb", "box: tmin ≤ tmax not tested"),
        ("slab-2axes", "aabb", "box: without z"),
        ("slab-tmax", "aabb", "box: tmax"),
        ("slab-noswap", "aabb", "box: y not sorted"),
        ("plane-no-p", "aabb", "box: B / d"),
        ("tri-uv", "triangle", "triangle: u + v ≤ 1 not tested"),
        ("tri-uv", "triangle", "triangle: u ≤ 1, v ≤ 1 for u + v ≤ 1"),
        ("tri-neg", "triangle", "triangle: v ≥ 0 not tested"),
        ("no-znear", "rule", "zNear not tested"),
        ("zfar-t", "rule", "t ≤ zFar"),
        ("att-no2", "light", "1 − t / |T − P|"),
        ("att-no2", "light", "1 − t / (4 |T − P|)"),
        ("att-square", "light", "1 − (t / 2 |T − P|)²"),
        ("att-square", "light", "1 − √(t / 2 |T − P|)"),
        ("att-zfar", "light", "1 − t / zFar"),
        ("att-inverse", "light", "1 / (1 + t)"),
        ("att-inv", "light", "t / 2 |T − P|"),
        ("att-none", "light", "no attenuation"),
        ("gamma", "bytes", "√colour"),
        ("gamma", "bytes", "colour²"),
    ];

    private Vector3 P, T, W, U, V;

    public Picture Draw()
    {
        var camera = scene.Camera;
        (P, T) = (camera.Position, camera.Target);
        var (width, height) = ((double)camera.Width, (double)camera.Height);
        W = Is("W = (T − P) / |T − P|") ? Unit(T - P) : Is("W = −T / |T|") ? Unit(-T) : Is("W = P / |P|") ? Unit(P)
            : Is("W not normalised") ? P - T : Unit(P - T);
        U = Is("U = W × up") ? Unit(Cross(W, camera.Up)) : Is("U not normalised") ? Cross(camera.Up, W) : Unit(Cross(camera.Up, W));
        V = Is("V = U × W") ? Cross(U, W) : Is("V = up") ? Unit(camera.Up) : Is("V = up × U") ? Cross(camera.Up, U) : Cross(W, U);
        var angle = Is("tan(fovY / 2) in degrees") ? camera.FovY : Is("fovY · π, without / 180") ? camera.FovY * Math.PI
            : Is("fovY / 180, without π") ? camera.FovY / 180 : camera.FovY / 180 * Math.PI;
        var h = Is("h = 2 tan(fovY)") ? 2 * Math.Tan(angle) : Is("h = tan(fovY)") ? Math.Tan(angle) : Is("h = tan(fovY / 2)") ? Math.Tan(angle / 2)
            : Is("h = 4 tan(fovY / 2)") ? 4 * Math.Tan(angle / 2) : Is("h = 2 sin(fovY / 2)") ? 2 * Math.Sin(angle / 2) : 2 * Math.Tan(angle / 2);
        var w = Is("w = h · height / width") ? h * height / width : Is("w = h") ? h : h * width / height;
        if (Is("w = 2 tan(fovY / 2), h = w · height / width")) (w, h) = (h, h * height / width);
        var offset = camera.Sample == PixelSample.Center ? 0.5 : 0;
        return Picture.Of(camera.Width, camera.Height, (x, y) =>
        {
            var (c, r) = (x + offset, (Is("r = y") ? y : Is("r = height − y") ? height - y : height - 1 - y) + offset);
            var uc = w * (c / (Is("c / height and r / width") ? height : Is("c / (width − 1)") ? width - 1 : width))
                - (Is("uc without − w / 2") ? 0 : Is("− w and − h") ? w : w / 2);
            var ur = h * (r / (Is("c / height and r / width") || Is("ur = h r / width − h / 2") ? width : height))
                - (Is("− w and − h") ? h : Is("+ h / 2") ? -h / 2 : h / 2);
            if (Is("uc V + ur U")) (uc, ur) = (ur, uc);
            if (Is("ur U + ur V")) uc = ur;
            return Cast(Unit(uc * U + ur * V + (Is("uc U + ur V + W") ? W : -W)));
        });
    }

    private bool Is(string what) => made == what;

    private (byte, byte, byte) Cast(Vector3 d)
    {
        var (camera, best) = (scene.Camera, double.PositiveInfinity);
        Model? hit = null;
        foreach (var model in scene.Models)
        {
            foreach (var t in Crossings(model, d))
            {
                var (depth, z) = (t * -Dot(d, W), camera.Clip == ClipMode.Distance);
                var (near, far) = z ? (t, t) : (depth, depth);
                if (Is("t ≤ zFar")) far = z ? depth : t;
                if (!(t > camera.Bias && (near >= camera.ZNear || Is("zNear not tested")) && far <= camera.ZFar)) continue;
                if (t < best) (best, hit) = (t, model);
                break;
            }
        }
        if (hit is null) return scene.Background.ToBytes();
        var share = best / (2 * (T - P).Length);
        var light = made switch
        {
            "1 − t / |T − P|" => 1 - 2 * share,
            "1 − t / (4 |T − P|)" => 1 - share / 2,
            "1 − (t / 2 |T − P|)²" => 1 - share * share,
            "1 − √(t / 2 |T − P|)" => 1 - Math.Sqrt(share),
            "1 − t / zFar" => 1 - best / camera.ZFar,
            "1 / (1 + t)" => 1 / (1 + best),
            "t / 2 |T − P|" => share,
            "no attenuation" => 1,
            _ => 1 - share,
        };
        light = Math.Max(0, light);
        return (Level(light * hit.Color.R), Level(light * hit.Color.G), Level(light * hit.Color.B));
    }

    private byte Level(double channel)
    {
        channel = Math.Clamp(channel, 0, 1);
        return (byte)(255 * (Is("√colour") ? Math.Sqrt(channel) : Is("colour²") ? channel * channel : channel) + 0.5);
    }

    private double[] Crossings(Model model, Vector3 d) => model switch
    {
        Model<Plane> { Primitive: var p } => [OnPlane(p.Point, p.Normal, d, "plane")],
        Model<Sphere> { Primitive: var s } => OnSphere(s.Center, s.Radius, d),
        Model<Aabb> { Primitive: var b } => OnBox([b.Min.X, b.Min.Y, b.Min.Z], [b.Max.X, b.Max.Y, b.Max.Z], [P.X, P.Y, P.Z], [d.X, d.Y, d.Z]),
        Model<Circle> { Primitive: var c } => OnCircle(c.Center, c.Normal, c.Radius, d),
        Model<Triangle> { Primitive: var t } => OnTriangle(t.A, t.B, t.C, d),
        _ => throw new NotSupportedException(),
    };

    private double OnPlane(Vector3 Q, Vector3 n, Vector3 d, string kind)
    {
        var way = Is($"{kind}: Q·n / d·n") ? Q : Is($"{kind}: (P − Q)·n / d·n") ? P - Q : Q - P;
        return Dot(way, n) / (Is($"{kind}: (Q − P)·n") ? 1 : Dot(d, n));
    }

    private double[] OnSphere(Vector3 C, double R, Vector3 d)
    {
        if (Is("sphere: 2 R")) R *= 2;
        if (Is("sphere: b² − ac, b = 2 d·O") || Is("sphere: / a for / 2a"))
        {
            var (a, b, c) = (Dot(d, d), 2 * Dot(d, P - C), Dot(P - C, P - C) - R * R);
            var D = b * b - (Is("sphere: b² − ac, b = 2 d·O") ? 1 : 4) * a * c;
            var under = (Is("sphere: / a for / 2a") ? 1 : 2) * a;
            return D < 0 ? [] : [(-b - Math.Sqrt(D)) / under, (-b + Math.Sqrt(D)) / under];
        }
        var L = Is("sphere: L = P − C") ? P - C : Is("sphere: L = C") ? C : C - P;
        var t_ca = Dot(L, d);
        var D2 = Dot(L, L) + (Is("sphere: D² = L² + t_ca²") ? 1 : -1) * t_ca * t_ca;
        if (D2 > (Is("sphere: √(R − D²), and D² > R asked") ? R : R * R)) return [];
        var t_hc = Is("sphere: √(R − D²), and D² > R asked") ? Math.Sqrt(R - D2) : Is("sphere: √(R² − D)") ? Math.Sqrt(R * R - Math.Sqrt(D2))
            : Is("sphere: t_hc = R² − D²") ? R * R - D2 : Is("sphere: t_hc = R") ? R : Math.Sqrt(R * R - D2);
        return Is("sphere: t_ca + t_hc") ? [t_ca + t_hc] : [t_ca - t_hc, t_ca + t_hc];
    }

    private double[] OnBox(double[] B0, double[] B1, double[] from, double[] d)
    {
        var (tmin, tmax) = (Is("box: tmin = min") ? double.PositiveInfinity : double.NegativeInfinity, double.PositiveInfinity);
        for (var i = 0; i < (Is("box: without z") ? 2 : 3); i++)
        {
            var origin = Is("box: B / d") ? 0 : from[i];
            var (t0, t1) = ((B0[i] - origin) / d[i], (B1[i] - origin) / d[i]);
            if (t0 > t1 && !(i == 1 && Is("box: y not sorted"))) (t0, t1) = (t1, t0);
            (tmin, tmax) = (Is("box: tmin = min") ? Math.Min(tmin, t0) : Math.Max(tmin, t0), Math.Min(tmax, t1));
        }
        return tmin > tmax && !Is("box: tmin ≤ tmax not tested") ? [] : Is("box: tmax") ? [tmax] : [tmin, tmax];
    }

    private double[] OnCircle(Vector3 C, Vector3 n, double R, Vector3 d)
    {
        var t = OnPlane(C, n, d, "circle");
        var distance = ((Is("circle: X = t d") ? t * d : P + t * d) - C).Length;
        if (Is("circle: |X − C|² ≤ R")) distance *= distance;
        var most = Is("circle: |X − C| ≤ R²") ? R * R : Is("circle: R / 2") ? R / 2 : R;
        return distance <= most || Is("circle: the radius not tested") ? [t] : [];
    }

    private double[] OnTriangle(Vector3 A, Vector3 B, Vector3 C, Vector3 d)
    {
        var n = Cross(B - A, C - A);
        var t = OnPlane(A, n, d, "triangle");
        var X = P + t * d;
        var (u, v) = (Dot(n, Cross(A - C, X - C)) / Dot(n, n), Dot(n, Cross(B - A, X - A)) / Dot(n, n));
        var last = Is("triangle: u + v ≤ 1 not tested") || (Is("triangle: u ≤ 1, v ≤ 1 for u + v ≤ 1") ? u <= 1 && v <= 1 : u + v <= 1);
        return u >= 0 && (v >= 0 || Is("triangle: v ≥ 0 not tested")) && last ? [t] : [];
    }

    private static Vector3 Unit(Vector3 a) => a / Math.Sqrt(Dot(a, a));

    private static double Dot(Vector3 a, Vector3 b) => a.X * b.X + a.Y * b.Y + a.Z * b.Z;

    private static Vector3 Cross(Vector3 a, Vector3 b) => new(a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X);
}
