namespace RayCaster.Teaching;

/// <summary>Where the ray's origin P is forgotten: in the t of one shape or of several, or in X = P + t d.</summary>
internal static class OriginMistakes
{
    private const Affects Shapes = Affects.Planes | Affects.Spheres | Affects.Boxes | Affects.Circles | Affects.Triangles;

    public static Mistake[] All =>
    [
        new Mistake("plane-no-p", Shapes, Slides.RayPlane, "plane: Q·n / d·n, without the camera's position P",
            WithoutP(Affects.Planes),
            "Shapes lie as if the camera were at the origin, or are missing.",
            "The ray begins at P. Where is P in your t?",
            "t = (Q − P)·n / d·n; for a sphere L = C − P, for a box t0 = (B0 − P) / d.")
            .Or("circle: neither t nor X with P", WithoutP(Affects.Circles))
            .Or("triangle: neither t nor X with P", WithoutP(Affects.Triangles))
            .Or("sphere: L = C, without P", WithoutP(Affects.Spheres))
            .Or("box: B0 / d and B1 / d, without P", WithoutP(Affects.Boxes))
            .Or("every shape: the ray starts at the origin of the world", WithoutP(Shapes)),
    ];

    /// <summary>What has its ray start at the origin lies, seen from P, as much farther on as P is from there.</summary>
    private static Action<Lab> WithoutP(Affects shapes) => lab =>
    {
        var P = lab.P;
        if (shapes.HasFlag(Affects.Planes)) lab.Plane.Becomes(cross => (plane, d) => cross(plane with { Point = plane.Point + P }, d));
        if (shapes.HasFlag(Affects.Spheres)) lab.Sphere.Becomes(cross => (sphere, d) => cross(sphere with { Center = sphere.Center + P }, d));
        if (shapes.HasFlag(Affects.Boxes)) lab.Box.Becomes(cross => (box, d) => cross(new(box.Min + P, box.Max + P), d));
        if (shapes.HasFlag(Affects.Circles)) lab.Circle.Becomes(cross => (circle, d) => cross(circle with { Center = circle.Center + P }, d));
        if (!shapes.HasFlag(Affects.Triangles)) return;
        lab.Triangle.Becomes(cross => (triangle, d) => cross(new(triangle.A + P, triangle.B + P, triangle.C + P), d));
        lab.TrianglesReachOut = true;
    };
}
