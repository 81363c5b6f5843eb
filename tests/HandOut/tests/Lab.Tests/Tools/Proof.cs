using RayCaster;

namespace Lab.Tests;

/// <summary>Which slides' formulas give the library's numbers in a scene: a hint does not ask about them, but about those that do not.</summary>
public sealed class Proof(RayCaster.Scene scene)
{
    private const int RaysAcross = 24;

    /// <summary>More wrong rays than the last bits turn on outlines.</summary>
    private const double Many = 0.01;

    private readonly Scene mine = SceneFile.Of(scene);

    /// <summary>Whether the formula of a slide is right for this scene; null where that is not known.</summary>
    public bool? IsRight(string slide)
    {
        try
        {
            return slide switch
            {
                "IDE & Vectors" => IsVectorRight(),
                "Camera" => IsCameraRight(),
                "Camera Pixel Translation" => IsCameraRight() ? AreRight(Pixels.Select(IsDirectionRight)) : null,
                "Ray Casting" => AreRight(Pixels.Select(IsColorRight)) == false ? false : null, // with wrong hits, too, the colour is theirs
                "Primitive Shading" => IsShadingRight(),
                "Ray – Plane Intersection" => IsShapeRight<RayCaster.Plane>(),
                "Sphere – Geometric Solution" => IsShapeRight<RayCaster.Sphere>(),
                "AABB – intersection parameters" => IsSlabRight(),
                "AABB checking for intersection" => IsSlabRight() ? IsShapeRight<RayCaster.Aabb>() : null,
                "Circle" => IsShapeRight<RayCaster.Circle>(),
                "Triangle" => IsShapeRight<RayCaster.Triangle>(),
                _ => null,
            };
        }
        catch (Exception) // of a body: the tests report it
        {
            return null;
        }
    }

    private IEnumerable<(int C, int R)> Pixels =>
        from c in Enumerable.Range(0, RaysAcross)
        from r in Enumerable.Range(0, RaysAcross)
        select (c * scene.Camera.Width / RaysAcross, r * scene.Camera.Height / RaysAcross);

    private static bool? AreRight(IEnumerable<bool> rays)
    {
        var results = rays.ToList();
        var wrong = results.Count(isRight => !isRight);
        return results.Count > 0 && wrong == 0 ? true : wrong > Many * results.Count ? false : null;
    }

    private static bool IsVectorRight()
    {
        RayCaster.Vector3 a = new(1.5, -2, 3), b = new(-4, 0.5, 7);
        Vector3 c = RayAssert.Mine(a), d = RayAssert.Mine(b);
        return RayAssert.AreEqual(a + b, c + d) && RayAssert.AreEqual(a - b, c - d) && RayAssert.AreEqual(2.5 * a, 2.5 * c)
            && RayAssert.AreEqual(a % b, c % d) && RayAssert.AreEqual(a * b, c * d) && RayAssert.AreEqual(a.Length, c.Length);
    }

    private bool IsCameraRight()
    {
        var (right, camera) = (scene.Camera, mine.Camera);
        return RayAssert.AreEqual(right.W, camera.W) && RayAssert.AreEqual(right.U, camera.U) && RayAssert.AreEqual(right.V, camera.V)
            && RayAssert.AreEqual(right.PlaneHeight, camera.h) && RayAssert.AreEqual(right.PlaneWidth, camera.w);
    }

    private bool IsDirectionRight((int C, int R) pixel)
    {
        var d = scene.Camera.Direction<Scalar>(pixel.C, pixel.R);
        var offset = mine.Camera.SampleOffset;
        return RayAssert.AreEqual(new RayCaster.Vector3(d.X, d.Y, d.Z), mine.Camera.Direction(pixel.C + offset, pixel.R + offset));
    }

    /// <summary>Whether CastRay returns what the lab's own ray, models and shading make.</summary>
    private bool IsColorRight((int C, int R) pixel)
    {
        var ray = mine.Camera.RayThrough(pixel.C, pixel.R);
        foreach (var model in mine.Models) model.Intersect(ray);
        var right = ray.HitModel == null ? mine.Background : mine.Camera.Shade(ray);
        return mine.CastRay(pixel.C, pixel.R).ToBytes() == right.ToBytes();
    }

    private bool IsShadingRight()
    {
        var model = new Plane(Vector3.Zero, new(1, 0, 0)) { Color = new(1, 0, 0) };
        var camera = mine.Camera;
        return Enumerable.Range(1, 12).Select(i => i * scene.Camera.FadeDistance / 10).All(t => RayAssert.AreEqual(
            Math.Max(0, 1 - t / scene.Camera.FadeDistance),
            camera.Shade(new(camera.Position, new(1, 0, 0)) { HitParameter = t, HitModel = model, DepthPerT = 0.5 }).R));
    }

    /// <summary>Whether the intersection parameters of a box are right, which its other formulas use.</summary>
    public static bool IsSlabRight()
    {
        return Is(1, 3, 0, 0.5, (2, 6)) && Is(1, 3, 5, -1, (2, 4)) && Is(1, 3, 2, 0.5, (-2, 2));

        static bool Is(double B0, double B1, double P, double d, (double First, double Second) right) =>
            Aabb.Slab(B0, B1, P, d) is var (first, second) && RayAssert.AreEqual(right.First, first) && RayAssert.AreEqual(right.Second, second);
    }

    /// <summary>The rays are the library's, and so is what counts: nothing but the shape's formula can differ.</summary>
    private bool? IsShapeRight<P>() where P : struct, IPrimitive => AreRight(
        from model in scene.Models.OfType<Model<P>>()
        from pixel in Pixels
        select IsHitRight(model, scene.Camera.RayThrough(pixel.C, pixel.R)));

    private static bool IsHitRight(RayCaster.Model model, RayCaster.Ray right)
    {
        var ray = new CountingRay(right);
        SceneFile.PartsOf(model).Single().Intersect(ray);
        return RayAssert.AreEqual(model.Intersect(right) ?? double.PositiveInfinity, ray.HitParameter);
    }

    private sealed class CountingRay(RayCaster.Ray right) : Ray(RayAssert.Mine(right.Origin), RayAssert.Mine(right.Direction))
    {
        public override void Hit(double t, Model model)
        {
            if (right.Counts(t) && t < HitParameter) (HitParameter, HitModel) = (t, model);
        }
    }
}
