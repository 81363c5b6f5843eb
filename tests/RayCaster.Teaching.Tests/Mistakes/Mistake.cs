namespace RayCaster.Teaching.Tests.Mistakes;

/// <summary>One thing that people get wrong in a ray caster. <see cref="SlideCaster"/> draws with one of them, or with two.</summary>
internal sealed class Mistake
{
    private static readonly List<Mistake> all = [];

    private Mistake(string id, string what) => (Id, What) = (id, what);

    /// <summary>No mistake.</summary>
    public static readonly Mistake None = new("ok", "nothing wrong");

    // The camera.
    public static readonly Mistake WSign = Plant("w-sign", "W = +(T − P)");
    public static readonly Mistake DirPlusW = Plant("dir-plus-w", "d = uc U + ur V + W");
    public static readonly Mistake UCross = Plant("u-cross", "U = W × up (V = W × U follows)");
    public static readonly Mistake VCross = Plant("v-cross", "V = U × W");
    public static readonly Mistake UOnly = Plant("u-only", "U to the left, V kept");
    public static readonly Mistake Rows = Plant("rows", "row r written as line r, not height − 1 − r");
    public static readonly Mistake Cols = Plant("cols", "columns from the right");
    public static readonly Mistake Rad = Plant("rad", "degrees into Math.Tan");
    public static readonly Mistake NoHalf = Plant("nohalf", "h = 2 tan(fovY)");
    public static readonly Mistake No2 = Plant("no2", "h = tan(fovY / 2)");
    public static readonly Mistake AspectInv = Plant("aspect-inv", "w = h · height / width");
    public static readonly Mistake AspectNone = Plant("aspect-none", "w = h");
    public static readonly Mistake AspectInt = Plant("aspect-int", "w = h · (width / height), divided in integers");
    public static readonly Mistake FovHoriz = Plant("fov-horiz", "fovY taken from left to right");
    public static readonly Mistake PixInt = Plant("pix-int", "w · (c / width), divided in integers");
    public static readonly Mistake NoCenter = Plant("no-center", "uc, ur without − w / 2, − h / 2");
    public static readonly Mistake Center = Plant("center", "pixel centres for corners (corners for centres)");
    public static readonly Mistake Wm1 = Plant("wm1", "c / (width − 1), r / (height − 1)");
    public static readonly Mistake Transpose = Plant("transpose", "row and column swapped in the picture");
    public static readonly Mistake UUnnorm = Plant("u-unnorm", "U not normalised");
    public static readonly Mistake WUnnorm = Plant("w-unnorm", "W not normalised");
    public static readonly Mistake LenNoSqrt = Plant("len-nosqrt", "length without the square root");
    public static readonly Mistake CrossY = Plant("cross-y", "cross product: sign of y");
    public static readonly Mistake CrossZ = Plant("cross-z", "cross product: z = ax by − ay by");
    public static readonly Mistake DirUnnorm = Plant("dir-unnorm", "d not normalised");
    public static readonly Mistake DirUnnormA1 = Plant("dir-unnorm-a1", "d not normalised, and the sphere takes a = 1");

    // Which hit shows.
    public static readonly Mistake NoT0 = Plant("no-t0", "no least t at all: what lies behind shows");
    public static readonly Mistake LastHit = Plant("last-hit", "the last model hit shows");
    public static readonly Mistake FarHit = Plant("far-hit", "the farthest hit shows");
    public static readonly Mistake Best0 = Plant("best0", "the best t starts at 0");
    public static readonly Mistake ZNearT = Plant("znear-t", "zNear measures t for depth (depth for t)");
    public static readonly Mistake ZFarT = Plant("zfar-t", "zFar measures t for depth (depth for t)");
    public static readonly Mistake ZBothT = Plant("zboth-t", "zNear and zFar measure t for depth (depth for t)");
    public static readonly Mistake ClipAfter = Plant("clip-after", "clipped after the nearest was chosen");
    public static readonly Mistake NoZNear = Plant("no-znear", "zNear ignored");
    public static readonly Mistake NoZFar = Plant("no-zfar", "zFar ignored");
    public static readonly Mistake BiasBig = Plant("bias-big", "a bias of 1 in place of zNear");

    // The shapes.
    public static readonly Mistake RNoSq = Plant("r-nosq", "sphere: R for R²");
    public static readonly Mistake DiscNan = Plant("disc-nan", "sphere: root of a negative number, and NaN passes for a hit");
    public static readonly Mistake FarRoot = Plant("far-root", "sphere: the far root");
    public static readonly Mistake NearRootOnly = Plant("near-root-only", "sphere: the near root or none");
    public static readonly Mistake OcSign = Plant("oc-sign", "sphere: C − P for P − C");
    public static readonly Mistake Disc2 = Plant("disc-2", "sphere: b² − ac with b = 2 …");
    public static readonly Mistake PlaneSign = Plant("plane-sign", "plane: (P − Q)·n");
    public static readonly Mistake PlaneCull = Plant("plane-cull", "plane: back side left out");
    public static readonly Mistake SlabNoSwap = Plant("slab-noswap", "box: t0 and t1 not sorted");
    public static readonly Mistake SlabMinMin = Plant("slab-minmin", "box: t_min is the least way in");
    public static readonly Mistake Slab2Axes = Plant("slab-2axes", "box: z forgotten");
    public static readonly Mistake SlabTMax = Plant("slab-tmax", "box: t_max shows");
    public static readonly Mistake SlabInvNan = Plant("slab-inv-nan", "box: 0 · (1 / 0) is NaN");
    public static readonly Mistake SlabInside = Plant("slab-inside", "box: not seen from inside");
    public static readonly Mistake CircNoSq = Plant("circ-nosq", "circle: |X − C|² ≤ R");
    public static readonly Mistake CircInf = Plant("circ-inf", "circle: no radius");
    public static readonly Mistake TriUv = Plant("tri-uv", "triangle: no u + v ≤ 1");
    public static readonly Mistake TriCull = Plant("tri-cull", "triangle: back side left out");
    public static readonly Mistake TriNeg = Plant("tri-neg", "triangle: no u ≥ 0, v ≥ 0");
    public static readonly Mistake TriArea = Plant("tri-area", "triangle: sum of areas compared with ==");

    // The colour and the file.
    public static readonly Mistake AttDepth = Plant("att-depth", "attenuation by depth");
    public static readonly Mistake AttNo2 = Plant("att-no2", "1 − t / |T − P|");
    public static readonly Mistake AttInv = Plant("att-inv", "t / (2 |T − P|)");
    public static readonly Mistake AttNone = Plant("att-none", "no attenuation");
    public static readonly Mistake AttOrigin = Plant("att-origin", "attenuation by the hit's distance from the origin of the world");
    public static readonly Mistake AttInt = Plant("att-int", "attenuation cut to an integer");
    public static readonly Mistake NoClamp = Plant("noclamp", "no clamp: a byte wraps round");
    public static readonly Mistake X256 = Plant("x256", "256 · channel");
    public static readonly Mistake Round = Plant("round", "truncated, not rounded");
    public static readonly Mistake Bgr = Plant("bgr", "red and blue swapped");
    public static readonly Mistake Gamma = Plant("gamma", "gamma of 2");
    public static readonly Mistake WhSwap = Plant("whswap", "width and height swapped in the header");
    public static readonly Mistake Crlf = Plant("crlf", "one byte too many before the pixels");
    public static readonly Mistake Ppm255 = Plant("ppm-255", "255 forgotten: a channel is 0 or 1 of 1");

    /// <summary>All of them, without <see cref="None"/>.</summary>
    public static IReadOnlyList<Mistake> All => all;

    /// <summary>A short name without blanks, the same for ever.</summary>
    public string Id { get; }

    /// <summary>What is wrong, in a few words.</summary>
    public string What { get; }

    /// <summary>The mistake of that name.</summary>
    public static Mistake Named(string id) => all.Single(mistake => mistake.Id == id);

    private static Mistake Plant(string id, string what)
    {
        var mistake = new Mistake(id, what);
        all.Add(mistake);
        return mistake;
    }
}
