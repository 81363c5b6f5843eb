using static RayCaster.Teaching.SlideFormulas;

namespace RayCaster.Teaching;

/// <summary>In the formulas of planes, and of circles and triangles, which lie in planes.</summary>
internal static class SurfaceMistakes
{
    public static Mistake[] All => [.. OfPlanes, .. OfCircles, .. OfTriangles];

    private static Mistake[] OfPlanes =>
    [
        new Mistake("plane-sign", PlaneReaders.All | Affects.Boxes, Slides.RayPlane, "plane: (P − Q)·n, so that t has the wrong sign",
            lab => lab.Plane.Becomes(cross => (plane, d) => new(-cross(plane, d).Near)),
            "Planes are missing; those behind the camera may show.",
            "A plane before the camera: is your t positive, and does P + t d lie in the plane?",
            "t = (Q − P)·n / d·n.")
            .In(OriginMistakes.FromNear)
            .Or(PlaneReaders.Of("(P − Q)·n, so that t has the wrong sign", (P, Q, n, d) => (P - Q) * n / (d * n)).Skip(1))
            .Or(PlaneReaders.Of("(Q + P)·n", (P, Q, n, d) => (P + Q) * n / (d * n)))
            .Or(PlaneReaders.Of("(Q − P)·n · d·n", (P, Q, n, d) => (Q - P) * n * (d * n)))
            .Or(PlaneReaders.Of("|(Q − P)·n| / d·n", (P, Q, n, d) => Math.Abs((Q - P) * n) / (d * n)))
            .Or(from t in ((string Is, Func<Vector3, Vector3, Vector3, Vector3, double> Of)[])
                [
                    ("(Q − P)·n / |d·n|", (P, Q, n, d) => (Q - P) * n / Math.Abs(d * n)), ("(Q − P)·n", (P, Q, n, d) => (Q - P) * n),
                    ("d·n / (Q − P)·n", (P, Q, n, d) => d * n / ((Q - P) * n)), ("(Q − P)·n / Q·n", (P, Q, n, d) => (Q - P) * n / (Q * n)),
                    ("(Q − P)·n / P·n", (P, Q, n, d) => (Q - P) * n / (P * n)), ("(Q − P)·d / d·n", (P, Q, n, d) => (Q - P) * d / (d * n)),
                    ("(Q − P)·n / (d·n)²", (P, Q, n, d) => (Q - P) * n / (d * n * (d * n))),
                    ("|Q − P| / d·n", (P, Q, n, d) => (Q - P).Length / (d * n)),
                ]
                from variant in PlaneReaders.Of(t.Is, t.Of).Take(3)
                select variant)
            .Or("box: (P − B0) / d and (P − B1) / d", lab => lab.Box.Becomes(cross => (box, d) => cross(box, -d)))
            .Or("box: (P − B0) / d for t0 alone", BoxMistakes.Crossed("xyz", (lo, hi, origin, d) => ((origin - lo) / d, (hi - origin) / d)))
            .Or("box: (P − B1) / d for t1 alone", BoxMistakes.Crossed("xyz", (lo, hi, origin, d) => ((lo - origin) / d, (origin - hi) / d)))
            .Or("box: (B0 + P) / d and (B1 + P) / d",
                lab => lab.Box.Becomes(cross => (box, d) => cross(new(box.Min + 2 * lab.P, box.Max + 2 * lab.P), d))),
        new Mistake("plane-cull", Affects.Planes | Affects.Circles, Slides.RayPlane,
            "plane: left out where n points away from the camera (d·n ≥ 0)",
            Cull(1, 0),
            "Some planes are missing; they come back when n is turned round.",
            "Does the slide say anything of the sign of d·n?",
            "Only d·n = 0 has no crossing; both sides are visible.")
            .Or("plane: left out where n points to the camera (d·n ≤ 0)", Cull(-1, 0))
            .Or("plane and circle: left out where n points away from the camera (d·n ≥ 0)", Cull(1, 1))
            .Or("plane and circle: left out where n points to the camera (d·n ≤ 0)", Cull(-1, -1))
            .Or("circle: left out where n points away from the camera (d·n ≥ 0)", Cull(0, 1))
            .Or("circle: left out where n points to the camera (d·n ≤ 0)", Cull(0, -1))
            .Or("plane, circle and triangle: left out where n points away from the camera (d·n ≥ 0)", Cull(1, 1, 1))
            .Or("plane, circle and triangle: left out where n points to the camera (d·n ≤ 0)", Cull(-1, -1, -1)),
    ];

    private static Mistake[] OfCircles =>
    [
        new Mistake("circ-nosq", Affects.Circles, Slides.Circle, "circle: |X − C|² ≤ R",
            CircleRadius(R => Math.Sqrt(R)),
            "Circles have a wrong size; one of radius 1 is right.",
            "Are both sides of your comparison lengths, or both squares?",
            "|X − C| ≤ R, or |X − C|² ≤ R².")
            .Or("circle: |X − C|² ≤ 2 R", CircleRadius(R => Math.Sqrt(2 * R)))
            .Or(Within("|x| + |y| + |z| of X − C", (lab, X, C) => new(Math.Abs(X.X - C.X) + Math.Abs(X.Y - C.Y) + Math.Abs(X.Z - C.Z), 0, 0)))
            .Or(Within("the greatest of |x|, |y| and |z| of X − C",
                (lab, X, C) => new(Math.Max(Math.Abs(X.X - C.X), Math.Max(Math.Abs(X.Y - C.Y), Math.Abs(X.Z - C.Z))), 0, 0)))
            .Or("circle: |X − C| ≤ 1, whatever R is", CircleRadius(_ => 1))
            .Or("circle: |X − C| ≤ R²", CircleRadius(R => R * R)),
        new Mistake("circ-inf", Affects.Circles, Slides.Circle, "circle: the radius is not asked",
            CircleRadius(_ => double.PositiveInfinity),
            "A circle covers the picture like an infinite plane.",
            "What is there of a circle that a plane has not?",
            "The plane's crossing X counts only where |X − C| ≤ R.")
            .Or("circle: |X − C| > R, an infinite plane with a hole", lab => lab.Circle.Becomes(cross => (circle, d) =>
                double.IsNaN(cross(circle, d).Near) ? cross(circle with { Radius = double.PositiveInfinity }, d) : None))
            .Or(Within("|X − C| without x", (lab, X, C) => new(0, X.Y - C.Y, X.Z - C.Z)))
            .Or(Within("|X − C| without y", (lab, X, C) => new(X.X - C.X, 0, X.Z - C.Z)))
            .Or(Within("|X − C| without z", (lab, X, C) => new(X.X - C.X, X.Y - C.Y, 0)))
            .Or(Within("the greatest of x, y and z of X − C",
                (lab, X, C) => new(Math.Max(0, Math.Max(X.X - C.X, Math.Max(X.Y - C.Y, X.Z - C.Z))), 0, 0)))
            .Or(Within("|X + C|", (_, X, C) => X + C))
            .Or(Within("|X|, without C", (_, X, _) => X))
            .Or(Within("t", (lab, X, _) => X - lab.P)),
    ];

    private static Mistake[] OfTriangles =>
    [
        new Mistake("tri-uv", Affects.Triangles, Slides.Triangle, "triangle: u ≥ 0 and v ≥ 0, but no u + v ≤ 1: an endless wedge",
            TriangleWhere((u, v) => u >= 0 && v >= 0),
            "Triangles reach beyond the side that is opposite to their first corner.",
            "Which condition draws the side from B to C? What are u and v at B and at C?",
            "u ≥ 0, v ≥ 0, u + v ≤ 1; u is 1 at B, v is 1 at C.")
            .Or(Asked(sides => sides.U && sides.V && !sides.Sum))
            .Or("triangle: n normalised, so that u and v are too large or too small", lab => lab.Whole.Is(n => n.Length))
            .Or("triangle: u and v not divided by n²", lab => lab.Whole.Is(_ => 1))
            .Or("triangle: u and v divided by 2 n²", lab => lab.Whole.Is(n => 2 * (n * n)))
            .Or("triangle: u + v ≤ 1 asked of volumes that are not divided by their sum", lab => lab.TriangleIs((triangle, d) =>
                lab.TriangleByVolumes(triangle, d, inside: (u, v, sum) => u / sum >= 0 && v / sum >= 0 && u + v <= 1)))
            .Or("triangle: u and v are volumes that are not divided by their sum", lab => lab.TriangleIs((triangle, d) =>
                lab.TriangleByVolumes(triangle, d, inside: (u, v, _) => IsInside(u, v))))
            .Or("triangle: the three areas compared with twice the triangle's",
                lab => lab.TriangleIs((triangle, d) => lab.TriangleByAreas(triangle, d, slack: 1)))
            .Or(from third in ((string Is, Func<double, double, bool> Holds)[])
                [
                    ("u² + v² ≤ 1", (u, v) => u * u + v * v <= 1), ("u + v ≤ 1/2", (u, v) => u + v <= 0.5), ("u − v ≤ 1", (u, v) => u - v <= 1),
                    ("v − u ≤ 1", (u, v) => v - u <= 1), ("u + v ≥ 1", (u, v) => u + v >= 1), ("u v ≤ 1", (u, v) => u * v <= 1),
                ]
                select ($"triangle: {third.Is} where u + v ≤ 1 is meant", TriangleWhere((u, v) => u >= 0 && v >= 0 && third.Holds(u, v)))),
        new Mistake("tri-cull", Affects.Triangles, Slides.Triangle, "triangle: left out where its corners run clockwise (d·n ≥ 0)",
            Cull(0, 0, 1),
            "Some triangles are missing; they come back when two corners are swapped.",
            "Does the slide say anything of the sign of d·n?",
            "Only d·n = 0 has no crossing; both sides are visible.")
            .Or("triangle: left out where its corners run counter-clockwise (d·n ≤ 0)",
                Cull(0, 0, -1))
            .Or("circle and triangle: left out where n points away from the camera (d·n ≥ 0)", Cull(0, 1, 1))
            .Or("circle and triangle: left out where n points to the camera (d·n ≤ 0)", Cull(0, -1, -1)),
        new Mistake("tri-neg", Affects.Triangles, Slides.Triangle, "triangle: u + v ≤ 1, but neither u ≥ 0 nor v ≥ 0: a half-plane",
            TriangleWhere((u, v) => u + v <= 1),
            "A triangle covers a large part of the picture.",
            "Are u and v positive in the middle of the triangle? Which conditions draw the two sides at A?",
            "u ≥ 0, v ≥ 0, u + v ≤ 1.")
            .Or(Asked(sides => !sides.U || !sides.V))
            .Or("triangle: u ≤ 0 where u ≥ 0 is meant", TriangleWhere((u, v) => u <= 0 && v >= 0 && u + v <= 1))
            .Or("triangle: v ≤ 0 where v ≥ 0 is meant", TriangleWhere((u, v) => u >= 0 && v <= 0 && u + v <= 1))
            .Or("triangle: −u for u", TriangleWhere((u, v) => IsInside(-u, v)))
            .Or("triangle: −v for v", TriangleWhere((u, v) => IsInside(u, -v)))
            .Or("triangle: −u for u and −v for v", TriangleWhere((u, v) => IsInside(-u, -v)))
            .Or(from volume in ((string Name, Vector3 Signs)[])[("w", new(-1, 1, 1)), ("u", new(1, -1, 1)), ("v", new(1, 1, -1))]
                select ($"triangle: the volume {volume.Name} with the wrong sign", (Action<Lab>)(lab =>
                    lab.TriangleIs((triangle, d) => lab.TriangleByVolumes(triangle, d, signs: volume.Signs)))))
            .Or("triangle: u ≥ 0 or v ≥ 0 where both are meant", TriangleWhere((u, v) => (u >= 0 || v >= 0) && u + v <= 1))
            .Or("triangle: u ≥ 0 and v ≥ 0, or u + v ≤ 1", TriangleWhere((u, v) => (u >= 0 && v >= 0) || u + v <= 1))
            .Or("triangle: whether u and v have the same sign", TriangleWhere((u, v) => u < 0 == v < 0))
            .Or("triangle: whether u and 1 − u − v have the same sign", TriangleWhere((u, v) => u < 0 == u + v > 1))
            .Or("triangle: whether v and 1 − u − v have the same sign", TriangleWhere((u, v) => v < 0 == u + v > 1))
            .Or("triangle: |u| + |v| ≤ 1", TriangleWhere((u, v) => Math.Abs(u) + Math.Abs(v) <= 1))
            .Or("triangle: |u| ≤ 1 and |v| ≤ 1", TriangleWhere((u, v) => Math.Abs(u) <= 1 && Math.Abs(v) <= 1))
            .Or("triangle: |u| ≤ 1, |v| ≤ 1, u + v ≤ 1", TriangleWhere((u, v) => Math.Abs(u) <= 1 && Math.Abs(v) <= 1 && u + v <= 1)),
        new Mistake("tri-area", Affects.Triangles, Slides.Triangle, "triangle: the sum of the three areas compared with ==",
            lab => lab.TriangleFormula = (triangle, d) => lab.TriangleByAreas(triangle, d, null),
            "Triangles are full of holes, like lace.",
            "Is 0.1 + 0.2 equal to 0.3 in doubles?",
            "u ≥ 0, v ≥ 0, u + v ≤ 1: no sums that must be equal to the last bit.")
            .Or("triangle: the sum of the three areas compared with ==, in other numbers or another order, which loses other pixels", lab =>
            {
                lab.Triangle.Becomes(cross => (triangle, d) => lab.IsSpared ? cross(triangle, d) : None);
                lab.Scatters = true;
            }),
    ];

    /// <summary>Leaves shapes out by the sign of d·n: 1 where n points away, −1 where it points to the camera, 0 never.</summary>
    private static Action<Lab> Cull(int planes, int circles, int triangles = 0) => lab =>
    {
        if (triangles != 0)
            lab.Triangle.Becomes(cross => (triangle, d) => triangles * (d * lab.NormalOf(triangle)) >= 0 ? None : cross(triangle, d));
        if (planes != 0) lab.Plane.Becomes(cross => (plane, d) => planes * (d * plane.Normal) >= 0 ? None : cross(plane, d));
        if (circles != 0) lab.Circle.Becomes(cross => (circle, d) => circles * (d * circle.Normal) >= 0 ? None : cross(circle, d));
    };

    /// <summary>Something else than |X − C| compared with R.</summary>
    private static IEnumerable<(string, Action<Lab>)> Within(string what, Func<Lab, Vector3, Vector3, Vector3> distance) =>
        [($"circle: {what} compared with R", CircleWhere((lab, circle, X) => distance(lab, X, circle.Center).Length <= circle.Radius))];

    /// <summary>Another question whether the point X of a circle's plane is in the circle.</summary>
    internal static Action<Lab> CircleWhere(Func<Lab, Circle, Vector3, bool> isIn) => lab => lab.Circle.Becomes(cross => (circle, d) =>
    {
        var endless = cross(circle with { Radius = double.PositiveInfinity }, d);
        return isIn(lab, circle, lab.P + (double)endless.Near * d) ? endless : None;
    });

    /// <summary>Another radius of circles, from the right one.</summary>
    internal static Action<Lab> CircleRadius(Func<double, double> R) =>
        lab => lab.Circle.Becomes(cross => (circle, d) => cross(circle with { Radius = R(circle.Radius) }, d));

    /// <summary>Some of u ≥ 0, v ≥ 0, u + v ≤ 1, u ≤ 1 and v ≤ 1 asked, the others not, without the first variants of tri-uv and tri-neg.</summary>
    private static IEnumerable<(string, Action<Lab>)> Asked(Func<(bool U, bool V, bool Sum), bool> belongs)
    {
        string[] names = ["u ≥ 0", "v ≥ 0", "u + v ≤ 1", "u ≤ 1", "v ≤ 1"];
        for (var asked = 0; asked < 32; asked++)
        {
            var sides = asked;
            if (sides is 3 or 4 || !belongs(((sides & 1) != 0, (sides & 2) != 0, (sides & 4) != 0))) continue;
            var all = string.Join(", ", names.Where((_, i) => (sides >> i & 1) != 0));
            yield return ($"triangle: only {(all == "" ? "the plane" : all)} asked", TriangleWhere((u, v) =>
                (u >= 0 || (sides & 1) == 0) && (v >= 0 || (sides & 2) == 0) && (u + v <= 1 || (sides & 4) == 0)
                && (u <= 1 || (sides & 8) == 0) && (v <= 1 || (sides & 16) == 0)));
        }
    }

    private static Action<Lab> TriangleWhere(Func<double, double, bool> inside) => lab => lab.Inside.Is(inside);
}
