using static RayCaster.Teaching.SlideFormulas;

namespace RayCaster.Teaching;

/// <summary>In the formulas of planes, and of circles and triangles, which lie in planes.</summary>
internal static class SurfaceMistakes
{
    public static Mistake[] All => [.. OfPlanes, .. OfCircles, .. OfTriangles];

    private static Mistake[] OfPlanes =>
    [
        new Mistake("plane-sign", Affects.Planes | Affects.Circles | Affects.Triangles | Affects.Boxes, Slides.RayPlane,
            "plane: (P − Q)·n, so that t has the wrong sign",
            lab => lab.Plane.Becomes(cross => (plane, d) => new(-cross(plane, d).Near)),
            "Planes are missing; those behind the camera may show.",
            "A plane before the camera: is your t positive, and does P + t d lie in the plane?",
            "t = (Q − P)·n / d·n.")
            .Or("box: (P − B0) / d and (P − B1) / d", lab => lab.Box.Becomes(cross => (box, d) => cross(box, -d))),
        new Mistake("plane-cull", Affects.Planes | Affects.Circles, Slides.RayPlane,
            "plane: left out where n points away from the camera (d·n ≥ 0)",
            lab => lab.Plane.Becomes(cross => (plane, d) => d * plane.Normal >= 0 ? None : cross(plane, d)),
            "Some planes are missing; they come back when n is turned round.",
            "Does the slide say anything of the sign of d·n?",
            "Only d·n = 0 has no crossing; both sides are visible.")
            .Or("circle: left out where n points away from the camera (d·n ≥ 0)",
                lab => lab.Circle.Becomes(cross => (circle, d) => d * circle.Normal >= 0 ? None : cross(circle, d))),
    ];

    private static Mistake[] OfCircles =>
    [
        new("circ-nosq", Affects.Circles, Slides.Circle, "circle: |X − C|² ≤ R",
            CircleRadius(R => Math.Sqrt(R)),
            "Circles have a wrong size; one of radius 1 is right.",
            "Are both sides of your comparison lengths, or both squares?",
            "|X − C| ≤ R, or |X − C|² ≤ R²."),
        new("circ-inf", Affects.Circles, Slides.Circle, "circle: the radius is not tested",
            CircleRadius(_ => double.PositiveInfinity),
            "A circle covers the picture like an infinite plane.",
            "What is there of a circle that a plane has not?",
            "The plane's crossing X counts only where |X − C| ≤ R."),
        new Mistake("circ-2axes", Affects.Circles, Slides.Circle, "circle: |X − C| of x and y only, without z",
            CircleWithout(offset => offset with { Z = 0 }),
            "Circles are long ovals, or endless strips.",
            "X and C are points in space. How many coordinates has X − C?",
            "|X − C| = √((X − C)·(X − C)), with x, y and z.")
            .Or("circle: |X − C| of x and z only, without y", CircleWithout(offset => offset with { Y = 0 }))
            .Or("circle: |X − C| of y and z only, without x", CircleWithout(offset => offset with { X = 0 })),
    ];

    private static Mistake[] OfTriangles =>
    [
        new Mistake("tri-uv", Affects.Triangles, Slides.Triangle, "triangle: u ≥ 0 and v ≥ 0, but no u + v ≤ 1: an endless wedge",
            lab => lab.TriangleByShares(inside: (u, v) => u >= 0 && v >= 0),
            "Triangles reach beyond the side that is opposite to their first corner.",
            "Which condition draws the side from B to C? What are u and v at B and at C?",
            "u ≥ 0, v ≥ 0, u + v ≤ 1; u is 1 at B, v is 1 at C.")
            .Or("triangle: n normalised, so that u and v are too large or too small", lab => lab.TriangleByShares(whole: n => n.Length)),
        new("tri-cull", Affects.Triangles, Slides.Triangle, "triangle: left out where its corners run clockwise (d·n ≥ 0)",
            lab => lab.Triangle.Becomes(cross => (triangle, d) => d * lab.NormalOf(triangle) >= 0 ? None : cross(triangle, d)),
            "Some triangles are missing; they come back when two corners are swapped.",
            "Does the slide say anything of the sign of d·n?",
            "Only d·n = 0 has no crossing; both sides are visible."),
        new("tri-neg", Affects.Triangles, Slides.Triangle, "triangle: u + v ≤ 1, but neither u ≥ 0 nor v ≥ 0: a half-plane",
            lab => lab.TriangleByShares(inside: (u, v) => u + v <= 1),
            "A triangle covers a large part of the picture.",
            "Are u and v positive in the middle of the triangle? Which conditions draw the two sides at A?",
            "u ≥ 0, v ≥ 0, u + v ≤ 1."),
        new Mistake("tri-area", Affects.Triangles, Slides.Triangle, "triangle: the sum of the three areas compared with ==",
            lab => lab.Triangle.Is((triangle, d) => ByAreas(lab, triangle, d)),
            "Triangles are full of holes, like lace.",
            "Is 0.1 + 0.2 equal to 0.3 in doubles?",
            "u ≥ 0, v ≥ 0, u + v ≤ 1: no sums that must be equal to the last bit.")
            .Or("triangle: the sum of the three areas compared with ==, in other numbers or another order, which loses other pixels", lab =>
            {
                lab.Triangle.Becomes(cross => (triangle, d) => lab.IsUnaffected ? cross(triangle, d) : None);
                lab.Scatters = true;
            }),
    ];

    /// <summary>The areas of the triangles that X makes with the sides are in sum that of the triangle, where X is in it.</summary>
    private static Crossings<Scalar> ByAreas(Lab lab, Triangle triangle, Vector3 d)
    {
        var (A, B, C) = (triangle.A, triangle.B, triangle.C);
        var n = lab.NormalOf(triangle);
        var t = (A - lab.P) * n / (d * n);
        var X = lab.P + t * d;
        return Area(C - B, X - B) + Area(A - C, X - C) + Area(B - A, X - A) == lab.Length.Do(n) ? new(t) : None;

        double Area(Vector3 a, Vector3 b) => lab.Length.Do(lab.Cross.Do(a, b));
    }

    /// <summary>The radius is compared with the length of a part of X − C.</summary>
    private static Action<Lab> CircleWithout(Func<Vector3, Vector3> partOf) => lab => lab.Circle.Is((circle, d) =>
    {
        var t = (circle.Center - lab.P) * circle.Normal / (d * circle.Normal);
        return lab.Length.Do(partOf(lab.P + t * d - circle.Center)) <= circle.Radius ? new(t) : None;
    });

    /// <summary>Another radius of circles, from the right one.</summary>
    internal static Action<Lab> CircleRadius(Func<double, double> R) =>
        lab => lab.Circle.Becomes(cross => (circle, d) => cross(circle with { Radius = R(circle.Radius) }, d));
}
