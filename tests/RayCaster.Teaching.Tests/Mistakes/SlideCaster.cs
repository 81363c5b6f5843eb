using static RayCaster.Teaching.Tests.Mistakes.Mistake;

namespace RayCaster.Teaching.Tests.Mistakes;

/// <summary>
/// A ray caster as a student writes it from the slides, in plain doubles and ifs, with a mistake or two. It takes nothing from the
/// library but the scene's numbers, so without a mistake it is also a second opinion on the library's pictures. Meshes are left out.
/// </summary>
internal sealed class SlideCaster
{
    private readonly Scene scene;
    private readonly Mistake mistake, second;
    private readonly Manner manner;
    private readonly Vector3 P, T, U, V, W;
    private readonly double w, h;

    private SlideCaster(Scene scene, Manner manner, Mistake mistake, Mistake second)
    {
        (this.scene, this.manner, this.mistake, this.second) = (scene, manner, mistake, second);
        var camera = scene.Camera;
        (P, T) = (Stored(camera.Position), Stored(camera.Target));

        W = Is(WSign) ? Unit(T - P) : Is(WUnnorm) ? -(T - P) : -Unit(T - P);
        U = Is(UCross) ? Cross(W, camera.Up) : Cross(camera.Up, W);
        if (!Is(UUnnorm)) U = Unit(U);
        V = Is(VCross) ? Cross(U, W) : Cross(W, U);
        if (Is(UOnly)) U = -U;

        var angle = Is(Rad) ? camera.FovY : camera.FovY * Math.PI / 180;
        var tangent = Math.Tan(Is(NoHalf) ? angle : angle / 2);
        h = Is(No2) ? tangent : 2 * tangent;
        w = Is(AspectInv) ? h * camera.Height / camera.Width
            : Is(AspectNone) ? h
            : Is(AspectInt) ? h * (camera.Width / camera.Height)
            : h * camera.Width / camera.Height;
        if (Is(FovHoriz)) (w, h) = (h, h * camera.Height / camera.Width);
        (W, U, V, w, h) = (Stored(W), Stored(U), Stored(V), Stored(w), Stored(h));
    }

    /// <summary>The picture that a program with that mistake writes; two of them turn its size.</summary>
    public static Picture Render(Scene scene, Mistake mistake) => Render(scene, Manner.OfTheSlides, mistake, None);

    /// <summary>The picture that a program with both mistakes writes, in its own manner; where both change one line, one of them has it.</summary>
    public static Picture Render(Scene scene, Manner manner, Mistake mistake, Mistake second) =>
        new SlideCaster(scene, manner, mistake, second).Render();

    private bool Is(Mistake which) => ReferenceEquals(mistake, which) || ReferenceEquals(second, which);

    /// <summary>A number as the program keeps it.</summary>
    private double Stored(double x) => manner.Float ? (float)x : x;

    private Vector3 Stored(Vector3 a) => manner.Float ? new((float)a.X, (float)a.Y, (float)a.Z) : a;

    private Picture Render()
    {
        var (width, height) = (scene.Camera.Width, scene.Camera.Height);
        var picture = new Picture(width, height);
        for (var r = 0; r < height; r++)
        {
            for (var c = 0; c < width; c++)
            {
                var color = CastRay(Direction(c, r));
                var (red, green, blue) = (ToByte(color.R), ToByte(color.G), ToByte(color.B));
                if (Is(Bgr)) (red, blue) = (blue, red);
                picture[Is(Cols) ? width - 1 - c : c, Is(Rows) ? r : height - 1 - r] = (red, green, blue);
            }
        }
        return AsFile(picture);
    }

    // ---- The ray of a pixel ----

    private Vector3 Direction(double c, double r)
    {
        var (width, height) = (scene.Camera.Width, scene.Camera.Height);
        if (scene.Camera.Sample == Sample.Center != (Is(Mistake.Center) != manner.OtherSample)) (c, r) = (c + 0.5, r + 0.5);
        if (Is(Wm1)) (width, height) = (width - 1, height - 1);
        var uc = Is(PixInt) ? w * ((int)c / width) : w * c / width;
        var ur = Is(PixInt) ? h * ((int)r / height) : h * r / height;
        if (!Is(NoCenter)) (uc, ur) = (uc - w / 2, ur - h / 2);
        var d = Stored(Stored(uc) * U + Stored(ur) * V + (Is(DirPlusW) ? W : -W));
        return Is(DirUnnorm) || Is(DirUnnormA1) ? d : Stored(Unit(d));
    }

    // ---- The nearest hit ----

    private Color CastRay(Vector3 d)
    {
        Model? hit = null;
        var best = Is(Best0) ? 0 : Is(FarHit) ? double.NegativeInfinity : double.PositiveInfinity;
        foreach (var model in scene.Models)
        {
            var (near, far) = Cross(model, d);
            if ((Counts(near, d) ? near : Counts(far, d) ? far : null) is not { } t) continue;
            var better = Is(FarHit) ? t > best : t < best;
            if (Is(DiscNan)) better = !(t >= best); // the same for numbers
            if (better || Is(LastHit)) (hit, best) = (model, t);
        }
        if (Is(ClipAfter) && !InClipRange(best, d)) hit = null;
        return hit is null ? scene.Background : Attenuation(best, d) * hit.Color;
    }

    private bool Counts(double? crossing, Vector3 d)
    {
        if (crossing is not { } t) return false;
        if (double.IsNaN(t)) return Is(DiscNan);
        if (Is(NoT0)) return InClipRange(t, d);
        if (Is(BiasBig)) return t > 1 && InClipRange(t, d);
        var bias = scene.Camera.Bias;
        return (bias == 0 ? t >= 0 : t > bias) && (Is(ClipAfter) || InClipRange(t, d));
    }

    private bool InClipRange(double t, Vector3 d)
    {
        var camera = scene.Camera;
        var (z, other) = camera.Clip == Clip.Depth ? (Depth(t, d), t) : (t, Depth(t, d));
        var near = Is(NoT0) || Is(NoZNear) || Is(BiasBig) || (Is(ZNearT) || Is(ZBothT) ? other : z) >= camera.ZNear;
        var far = Is(NoZFar) || (Is(ZFarT) || Is(ZBothT) ? other : z) <= camera.ZFar;
        return near && far;
    }

    private double Depth(double t, Vector3 d) => Stored(t * Stored(-(d * W)));

    // ---- The crossings of a ray with a shape, nearest first ----

    private (double? Near, double? Far) Cross(Model model, Vector3 d) => model switch
    {
        Model<Plane> plane => (Cross(plane.Primitive, d), null),
        Model<Sphere> sphere => Cross(sphere.Primitive, d),
        Model<Aabb> box => Cross(box.Primitive, d),
        Model<Circle> circle => (Cross(circle.Primitive, d), null),
        Model<Triangle> triangle => (Cross(triangle.Primitive, d), null),
        _ => throw new ArgumentException($"no formula for {model.GetType()}"),
    };

    private double? Cross(Plane plane, Vector3 d)
    {
        if (Is(PlaneCull) && d * plane.Normal >= 0) return null;
        return Is(PlaneSign) ? -CrossPlane(plane.Point, plane.Normal, d) : CrossPlane(plane.Point, plane.Normal, d);
    }

    private double? CrossPlane(Vector3 Q, Vector3 n, Vector3 d) =>
        Stored(d * n) == 0 ? null : Stored(Stored(Stored(Q - P) * n) / Stored(d * n));

    /// <summary>Slide "Sphere – Analytical Solution": a t² + b t + c = 0.</summary>
    private (double?, double?) Cross(Sphere sphere, Vector3 d)
    {
        var R = sphere.Radius;
        var CP = Stored(Is(OcSign) ? sphere.Center - P : P - sphere.Center);
        var a = Is(DirUnnormA1) ? 1 : Stored(d * d);
        var b = Stored(2 * (d * CP));
        var c = Stored(Stored(CP * CP) - Stored(Is(RNoSq) ? R : R * R));
        var discriminant = Stored(Stored(b * b) - Stored((Is(Disc2) ? 1 : 4) * a * c));
        if (discriminant < 0 && !Is(DiscNan)) return (null, null);
        var near = Stored((-b - Math.Sqrt(discriminant)) / (2 * a));
        var far = Stored((-b + Math.Sqrt(discriminant)) / (2 * a));
        return Is(FarRoot) ? (far, null) : Is(NearRootOnly) ? (near, null) : (near, far);
    }

    private (double?, double?) Cross(Aabb box, Vector3 d)
    {
        if (Slab(box.Min.X, box.Max.X, P.X, d.X) is not { } x) return (null, null);
        if (Slab(box.Min.Y, box.Max.Y, P.Y, d.Y) is not { } y) return (null, null);
        if (Slab(box.Min.Z, box.Max.Z, P.Z, d.Z) is not { } z) return (null, null);
        if (Is(Slab2Axes)) z = (double.NegativeInfinity, double.PositiveInfinity);
        var tMin = Is(SlabMinMin) ? Math.Min(Math.Min(x.In, y.In), z.In) : Math.Max(Math.Max(x.In, y.In), z.In);
        var tMax = Math.Min(Math.Min(x.Out, y.Out), z.Out);
        if (!(tMin <= tMax)) return (null, null);
        return Is(SlabTMax) ? (tMax, null) : Is(SlabInside) ? (tMin, null) : (tMin, tMax);
    }

    private (double In, double Out)? Slab(double lo, double hi, double origin, double direction)
    {
        (lo, hi) = (Stored(lo), Stored(hi));
        if (Is(SlabInvNan)) return Sorted(Stored((lo - origin) * Stored(1 / direction)), Stored((hi - origin) * Stored(1 / direction)));
        if (direction == 0) return lo <= origin && origin <= hi ? (double.NegativeInfinity, double.PositiveInfinity) : null;
        return Sorted(Stored((lo - origin) / direction), Stored((hi - origin) / direction));
    }

    private (double, double) Sorted(double t0, double t1) => Is(SlabNoSwap) ? (t0, t1) : (Math.Min(t0, t1), Math.Max(t0, t1));

    private double? Cross(Circle circle, Vector3 d)
    {
        if (CrossPlane(circle.Center, circle.Normal, d) is not { } t) return null;
        var CX = Stored(Stored(P + t * d) - circle.Center);
        var limit = Is(CircNoSq) ? circle.Radius : circle.Radius * circle.Radius;
        return Stored(CX * CX) <= Stored(limit) || Is(CircInf) ? t : null;
    }

    /// <summary>Slide "Triangle": u and v are shares of the area.</summary>
    private double? Cross(Triangle triangle, Vector3 d)
    {
        var (A, B, C) = (Stored(triangle.A), Stored(triangle.B), Stored(triangle.C));
        var n = Stored(Cross(Stored(B - A), Stored(C - A)));
        if (Is(TriCull) && d * n >= 0) return null;
        if (CrossPlane(A, n, d) is not { } t) return null;
        var X = Stored(P + t * d);
        var (overA, overB, overC) = (Stored(Cross(C - B, X - B)), Stored(Cross(A - C, X - C)), Stored(Cross(B - A, X - A)));
        if (Is(TriArea)) return Stored(Length(overA) + Length(overB) + Length(overC)) == Stored(Length(n)) ? t : null;
        var (u, v) = (Stored(overB * n / (n * n)), Stored(overC * n / (n * n)));
        return ((u >= 0 && v >= 0) || Is(TriNeg)) && (u + v <= 1 || Is(TriUv)) ? t : null;
    }

    // ---- The colour ----

    private double Attenuation(double t, Vector3 d)
    {
        var twice = Is(AttNo2) ? Length(T - P) : Length(2 * (T - P));
        var far = Is(AttDepth) ? Depth(t, d) : Is(AttOrigin) ? Length(P + t * d) : t;
        var attenuation = Stored(Is(AttNone) ? 1 : Is(AttInv) ? far / twice : 1 - far / twice);
        if (Is(AttInt)) attenuation = (int)attenuation;
        return Is(NoClamp) ? attenuation : Math.Max(0, attenuation);
    }

    private byte ToByte(double channel)
    {
        var half = manner.Truncates ? 0 : 0.5;
        if (Is(NoClamp)) return unchecked((byte)(int)(255 * channel + half));
        channel = Math.Clamp(channel, 0, 1);
        if (Is(Gamma)) channel = Math.Sqrt(channel);
        return Is(X256) ? (byte)Math.Min(256 * channel, 255)
            : Is(Mistake.Round) ? (byte)(255 * channel)
            : Is(Ppm255) ? (byte)(255 * (int)channel)
            : (byte)(255 * channel + half); // NaN becomes 0
    }

    // ---- The file: how it reads to those who open it ----

    private Picture AsFile(Picture picture)
    {
        if (Is(Transpose))
        {
            var turned = new Picture(picture.Height, picture.Width);
            for (var y = 0; y < picture.Height; y++)
                for (var x = 0; x < picture.Width; x++) turned[y, x] = picture[x, y];
            picture = turned;
        }
        if (Is(WhSwap))
        {
            var sheared = new Picture(picture.Height, picture.Width);
            picture.Rgb.CopyTo(sheared.Rgb, 0);
            picture = sheared;
        }
        if (Is(Crlf))
        {
            var shifted = new Picture(picture.Width, picture.Height);
            shifted.Rgb[0] = (byte)'\n';
            picture.Rgb.AsSpan(0, picture.Rgb.Length - 1).CopyTo(shifted.Rgb.AsSpan(1));
            picture = shifted;
        }
        return picture;
    }

    // ---- Vectors ----

    private double Length(Vector3 a) => Is(LenNoSqrt) ? a * a : Math.Sqrt(a * a);

    private Vector3 Unit(Vector3 a) => a / Length(a);

    private Vector3 Cross(Vector3 a, Vector3 b) => new(
        a.Y * b.Z - a.Z * b.Y,
        Is(CrossY) ? a.X * b.Z - a.Z * b.X : a.Z * b.X - a.X * b.Z,
        Is(CrossZ) ? a.X * b.Y - a.Y * b.Y : a.X * b.Y - a.Y * b.X);
}
