using RayCaster;

namespace Lab.Tests;

/// <summary>Which slides' formulas give the library's numbers in a scene: a hint does not ask about them.</summary>
public sealed class Proof(RayCaster.Scene scene)
{
    private const int RaysAcross = 24;

    private readonly Camera mine = SceneFile.Of(scene).Camera;

    /// <summary>Whether the formula of a slide is right for this scene; false for a slide without a check.</summary>
    public bool IsRight(string slide)
    {
        try
        {
            return slide switch
            {
                "IDE & Vectors" => IsVectorRight(),
                "Camera" => IsCameraRight(),
                "Camera Pixel Translation" => IsCameraRight() && Pixels().All(pixel => IsDirectionRight(pixel.C, pixel.R)),
                "Primitive Shading" => IsShadingRight(),
                "Ray – Plane Intersection" => IsShapeRight<RayCaster.Plane>(),
                "Sphere – Geometric Solution" => IsShapeRight<RayCaster.Sphere>(),
                "AABB – intersection parameters" or "AABB checking for intersection" => IsShapeRight<RayCaster.Aabb>(),
                "Circle" => IsShapeRight<RayCaster.Circle>(),
                "Triangle" => IsShapeRight<RayCaster.Triangle>(),
                _ => false,
            };
        }
        catch (Exception) // of a body: the tests report it
        {
            return false;
        }
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
        var right = scene.Camera;
        return RayAssert.AreEqual(right.W, mine.W) && RayAssert.AreEqual(right.U, mine.U) && RayAssert.AreEqual(right.V, mine.V)
            && RayAssert.AreEqual(right.PlaneHeight, mine.h) && RayAssert.AreEqual(right.PlaneWidth, mine.w);
    }

    private bool IsDirectionRight(int c, int r)
    {
        var d = scene.Camera.Direction<Scalar>(c, r);
        return RayAssert.AreEqual(new RayCaster.Vector3(d.X, d.Y, d.Z), mine.Direction(c + mine.SampleOffset, r + mine.SampleOffset));
    }

    private bool IsShadingRight()
    {
        var model = new Plane(Vector3.Zero, new(1, 0, 0)) { Color = new(1, 0, 0) };
        return Enumerable.Range(1, 12).Select(i => i * scene.Camera.FadeDistance / 10).All(t => RayAssert.AreEqual(
            Math.Max(0, 1 - t / scene.Camera.FadeDistance), mine.Shade(new(mine.Position, new(1, 0, 0)) { HitParameter = t, HitModel = model }).R));
    }

    /// <summary>The rays are the library's, so that nothing but the shape's formula can differ.</summary>
    private bool IsShapeRight<P>() where P : struct, IPrimitive
    {
        var models = scene.Models.OfType<Model<P>>().ToList();
        return models.Count > 0 && models.All(model => Pixels().All(pixel =>
        {
            var right = scene.Camera.RayThrough(pixel.C, pixel.R);
            var ray = new Ray(RayAssert.Mine(right.Origin), RayAssert.Mine(right.Direction))
            {
                Bias = mine.Bias,
                ZNear = mine.ZNear,
                ZFar = mine.ZFar,
                DepthPerT = right.DepthPerT,
            };
            SceneFile.PartsOf(model).Single().Intersect(ray);
            return RayAssert.AreEqual(model.Intersect(right) ?? double.PositiveInfinity, ray.HitParameter);
        }));
    }

    private IEnumerable<(int C, int R)> Pixels() =>
        from c in Enumerable.Range(0, RaysAcross)
        from r in Enumerable.Range(0, RaysAcross)
        select (c * scene.Camera.Width / RaysAcross, r * scene.Camera.Height / RaysAcross);
}
