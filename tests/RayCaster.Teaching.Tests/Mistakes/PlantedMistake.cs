namespace RayCaster.Teaching.Tests.Mistakes;

/// <summary>One thing that people get wrong in a ray caster, as a small change of the lab's source.</summary>
/// <param name="Id">A short name without blanks, the same for ever.</param>
/// <param name="What">What is wrong, in a few words.</param>
internal sealed record PlantedMistake(string Id, string What, params SourceEdit[] Edits)
{
    /// <summary>No mistake.</summary>
    public static readonly PlantedMistake None = new("ok", "nothing wrong");

    private const string SmallAreas =
        "if (((C - B) % (ray.At(t) - B)).Length + ((A - C) % (ray.At(t) - C)).Length + ((B - A) % (ray.At(t) - A)).Length == n.Length)";

    // What the other way of measuring zNear and zFar would be: depth for t, and t for depth.
    private static readonly SourceEdit[] other =
    [
        new("Ray", "DepthPerT = 1;", "DepthPerT = 1, OtherPerT = 1;"),
        new("Camera", ": -(d * W) }", ": -(d * W), OtherPerT = ClipsByDistance ? -(d * W) : 1 }"),
    ];
    private static readonly SourceEdit zNearOther = new("Ray", "ZNear <= z", "ZNear <= t * OtherPerT");
    private static readonly SourceEdit zFarOther = new("Ray", "z <= ZFar", "t * OtherPerT <= ZFar");
    private static readonly SourceEdit noZNear = new("Ray", "ZNear <= z", "true"), noZFar = new("Ray", "z <= ZFar", "true");
    private static readonly SourceEdit analytical = new("Sphere", "=> GeometricSolution", "=> AnalyticalSolution");
    private static readonly SourceEdit unnormalised = new("Camera", "* V - W).Normalized", "* V - W)");

    /// <summary>All of them, without <see cref="None"/>.</summary>
    public static IReadOnlyList<PlantedMistake> All { get; } =
    [
        // The camera.
        new("w-sign", "W = +(T − P)", new SourceEdit("Camera", "W = -(", "W = (")),
        new("dir-plus-w", "d = uc U + ur V + W", new SourceEdit("Camera", "ur * V - W", "ur * V + W")),
        new("u-cross", "U = W × up (V = W × U follows)", new SourceEdit("Camera", "Up % W", "W % Up")),
        new("v-cross", "V = U × W", new SourceEdit("Camera", "W % U;", "U % W;")),
        new("u-only", "U to the left, V kept", new SourceEdit("Camera", "h = 2 *", "U = -U; h = 2 *")),
        new("rows", "row r written as line r, not height − 1 − r", new SourceEdit("Scene", "Camera.Height - 1 - r]", "r]")),
        new("cols", "columns from the right", new SourceEdit("Scene", "picture[c,", "picture[Camera.Width - 1 - c,")),
        new("rad", "degrees into Math.Tan", new SourceEdit("Camera", " * Math.PI / 180", "")),
        new("nohalf", "h = 2 tan(fovY)", new SourceEdit("Camera", "fovY / 2", "fovY")),
        new("no2", "h = tan(fovY / 2)", new SourceEdit("Camera", "2 * Math.Tan", "Math.Tan")),
        new("aspect-inv", "w = h · height / width", new SourceEdit("Camera", "h * Width / Height;", "h * Height / Width;")),
        new("aspect-none", "w = h", new SourceEdit("Camera", "h * Width / Height;", "h;")),
        new("aspect-int", "w = h · (width / height), divided in integers", new SourceEdit("Camera", "h * Width / Height;", "h * (Width / Height);")),
        new("fov-horiz", "fovY taken from left to right", new SourceEdit("Camera", "w = h * Width / Height;", "w = h; h = w * Height / Width;")),
        new("pix-int", "w · (c / width), divided in integers",
            new("Camera", "h * r / Height", "h * ((int)r / Height)"), new("Camera", "w * c / Width", "w * ((int)c / Width)")),
        new("no-center", "uc, ur without − w / 2, − h / 2", new("Camera", " - h / 2", ""), new("Camera", " - w / 2", "")),
        new("center", "pixel centres for corners (corners for centres)",
            new("Camera", "c + SampleOffset", "c + 0.5 - SampleOffset"), new("Camera", "r + SampleOffset", "r + 0.5 - SampleOffset")),
        new("wm1", "c / (width − 1), r / (height − 1)",
            new("Camera", "r / Height", "r / (Height - 1)"), new("Camera", "c / Width", "c / (Width - 1)")),
        new("transpose", "row and column swapped in the picture",
            new("Scene", "Picture(Camera.Width, Camera.Height)", "Picture(Camera.Height, Camera.Width)"),
            new("Scene", "picture[c, Camera.Height - 1 - r]", "picture[Camera.Height - 1 - r, c]")),
        new("u-unnorm", "U not normalised", new SourceEdit("Camera", "(Up % W).Normalized", "(Up % W)")),
        new("w-unnorm", "W not normalised", new SourceEdit("Camera", "(Target - Position).Normalized", "(Target - Position)")),
        new("len-nosqrt", "length without the square root", new SourceEdit("Vector3", "Math.Sqrt(this * this)", "this * this")),
        new("cross-y", "cross product: sign of y", new SourceEdit("Vector3", "a.Z * b.X - a.X * b.Z", "a.X * b.Z - a.Z * b.X")),
        new("cross-z", "cross product: z = ax by − ay by", new SourceEdit("Vector3", "a.X * b.Y - a.Y * b.X", "a.X * b.Y - a.Y * b.Y")),
        new("dir-unnorm", "d not normalised", unnormalised, analytical),
        new("dir-unnorm-a1", "d not normalised, and the sphere takes |d| = 1", unnormalised),

        // Which hit shows.
        new("no-t0", "no least t at all: what lies behind shows", new("Ray", "Bias == 0 ? t >= 0 : t > Bias", "true"), noZNear),
        new("last-hit", "the last model hit shows", new SourceEdit("Ray", "|| t >= HitParameter", "")),
        new("far-hit", "the farthest hit shows",
            new SourceEdit("Ray", "t >= HitParameter", "HitModel != null && t <= HitParameter")),
        new("best0", "the best t starts at 0", new SourceEdit("Ray", "HitParameter = double.PositiveInfinity", "HitParameter = 0")),
        new("znear-t", "zNear measures t for depth (depth for t)", [.. other, zNearOther]),
        new("zfar-t", "zFar measures t for depth (depth for t)", [.. other, zFarOther]),
        new("zboth-t", "zNear and zFar measure t for depth (depth for t)", [.. other, zNearOther, zFarOther]),
        new("clip-after", "clipped after the nearest was chosen", noZNear, noZFar, new("Scene", "ray.HitModel == null",
            "!(ray.ZNear <= ray.HitParameter * ray.DepthPerT && ray.HitParameter * ray.DepthPerT <= ray.ZFar)")),
        new("no-znear", "zNear ignored", noZNear),
        new("no-zfar", "zFar ignored", noZFar),
        new("bias-big", "a bias of 1 in place of zNear", new("Ray", "Bias == 0 ? t >= 0 : t > Bias", "t > 1"), noZNear),

        // The shapes.
        new("r-nosq", "sphere: R for R²", new("Sphere", "> R * R", "> R"), new("Sphere", "Sqrt(R * R - D", "Sqrt(R - D")),
        new("disc-nan", "sphere: root of a negative number, and NaN passes for a hit",
            new("Sphere", "if (D * D > R * R) return;", ""), new("Ray", "!Counts(t)", "!Counts(t) && t == t")),
        new("far-root", "sphere: the far root", new SourceEdit("Sphere", "ray.Hit(t_ca - t_hc, this);", "")),
        new("near-root-only", "sphere: the near root or none", new SourceEdit("Sphere", "ray.Hit(t_ca + t_hc, this);", "")),
        new("oc-sign", "sphere: C − P for P − C", new SourceEdit("Sphere", "C - ray.Origin", "ray.Origin - C")),
        new("disc-2", "sphere: b² − ac with b = 2 …", analytical, new("Sphere", "b * b - 4 * a * c", "b * b - a * c")),
        new("plane-sign", "plane: (P − Q)·n", new SourceEdit("Plane", "Q - ray.Origin", "ray.Origin - Q")),
        new("plane-cull", "plane: back side left out", new SourceEdit("Plane", "n == 0", "n >= 0")),
        new("slab-noswap", "box: t0 and t1 not sorted", new SourceEdit("Aabb", "t0 <= t1 ? (t0, t1) : (t1, t0)", "(t0, t1)")),
        new("slab-minmin", "box: t_min is the smallest entry parameter",
            new SourceEdit("Aabb", "Math.Max(x0, Math.Max(y0, z0))", "Math.Min(x0, Math.Min(y0, z0))")),
        new("slab-2axes", "box: z forgotten",
            new SourceEdit("Aabb", "Slab(B0.Z, B1.Z, P.Z, d.Z)", "(double.NegativeInfinity, double.PositiveInfinity)")),
        new("slab-tmax", "box: t_max shows", new SourceEdit("Aabb", "ray.Hit(t_min, this);", "")),
        new("slab-inv-nan", "box: 0 · (1 / 0) is NaN",
            new("Aabb", "if (d == 0)", "if (false)"), new("Aabb", "t0 = (B0 - P) / d", "t0 = (B0 - P) * (1 / d)"),
            new("Aabb", "t1 = (B1 - P) / d", "t1 = (B1 - P) * (1 / d)"),
            new("Aabb", "t0 <= t1 ? (t0, t1) : (t1, t0)", "(Math.Min(t0, t1), Math.Max(t0, t1))")),
        new("slab-inside", "box: not seen from inside", new SourceEdit("Aabb", "ray.Hit(t_max, this);", "")),
        new("circ-nosq", "circle: |X − C|² ≤ R", new SourceEdit("Circle", "(X - C).Length", "(X - C) * (X - C)")),
        new("circ-inf", "circle: no radius", new SourceEdit("Circle", "if ((X - C).Length <= R)", "")),
        new("tri-uv", "triangle: no u + v ≤ 1", new SourceEdit("Triangle", "w / sum >= 0", "true")),
        new("tri-cull", "triangle: back side left out", new SourceEdit("Triangle", "d * n == 0", "d * n >= 0")),
        new("tri-neg", "triangle: no u ≥ 0, v ≥ 0", new SourceEdit("Triangle", "u / sum >= 0 && v / sum >= 0", "true")),
        new("tri-area", "triangle: sum of areas compared with ==",
            new SourceEdit("Triangle", "if (u / sum >= 0 && v / sum >= 0 && w / sum >= 0)", SmallAreas)),

        // The colour and the file.
        new("att-depth", "attenuation by depth", new SourceEdit("Camera", "ray.HitParameter /", "ray.HitParameter * -(ray.Direction * W) /")),
        new("att-no2", "1 − t / |T − P|", new SourceEdit("Camera", "2 * (Target - Position)", "1 * (Target - Position)")),
        new("att-inv", "t / (2 |T − P|)", new SourceEdit("Camera", "attenuation = 1 - ", "attenuation = ")),
        new("att-none", "no attenuation", new SourceEdit("Camera", "Math.Max(0, attenuation) * ", "")),
        new("att-origin", "attenuation by the hit's distance from the origin of the world",
            new SourceEdit("Camera", "ray.HitParameter /", "ray.At(ray.HitParameter).Length /")),
        new("att-int", "attenuation cut to an integer", new SourceEdit("Camera", "Math.Max(0, attenuation)", "Math.Max(0, (int)attenuation)")),
        new("noclamp", "no clamp: a byte wraps round",
            new("Camera", "Math.Max(0, attenuation)", "attenuation"),
            new("Color", "(byte)(Math.Clamp(channel, 0, 1) * 255 + 0.5)", "unchecked((byte)(int)(channel * 255 + 0.5))")),
        new("x256", "256 · channel",
            new("Color", "* 255 + 0.5", "* 256"), new("Color", "Math.Clamp(channel, 0, 1)", "Math.Clamp(channel, 0, 255 / 256.0)")),
        new("round", "truncated, not rounded", new SourceEdit("Color", "* 255 + 0.5", "* 255")),
        new("bgr", "red and blue swapped", new SourceEdit("Color", "(ToByte(R), ToByte(G), ToByte(B))", "(ToByte(B), ToByte(G), ToByte(R))")),
        new("gamma", "gamma of 2", new SourceEdit("Color", "Math.Clamp(channel, 0, 1)", "Math.Sqrt(Math.Clamp(channel, 0, 1))")),
        new("whswap", "width and height swapped in the header", new SourceEdit("Scene", "return picture;",
            "var file = new Picture(picture.Height, picture.Width); picture.Rgb.CopyTo(file.Rgb, 0); return file;")),
        new("crlf", "one byte too many before the pixels",
            new SourceEdit("Scene", "return picture;",
                "Array.Copy(picture.Rgb, 0, picture.Rgb, 1, picture.Rgb.Length - 1); picture.Rgb[0] = 10; return picture;")),
        new("ppm-255", "255 forgotten: a channel is 0 or 1 of 1",
            new SourceEdit("Color", "Math.Clamp(channel, 0, 1) * 255 + 0.5", "(int)Math.Clamp(channel, 0, 1) * 255")),
    ];

    /// <summary>A mistake that has no name.</summary>
    public static PlantedMistake Of(params SourceEdit[] edits) => new(string.Join(' ', edits.Select(edit => $"{edit.File}: {edit.New}")), "", edits);

    /// <summary>The mistake of that name.</summary>
    public static PlantedMistake Named(string id) => id == None.Id ? None : All.Single(mistake => mistake.Id == id);
}
