using static RayCaster.Teaching.SlideFormulas;

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
            .In(FromNear)
            .Or(PlaneReaders.Of("Q·n / d·n, without P", (_, Q, n, d) => Q * n / (d * n)).Skip(1))
            .Or(PlaneReaders.Of("P·n / d·n, without Q", (P, _, n, d) => P * n / (d * n)))
            .Or(PlaneReaders.Of("−P·n / d·n, without Q", (P, _, n, d) => -(P * n) / (d * n)))
            .Or(from X in ((string Is, Func<Vector3, double, Vector3, Vector3> Of)[])
                [
                    ("t d, without P", (_, t, d) => t * d), ("P + d", (P, _, d) => P + d), ("P − t d", (P, t, d) => P - t * d),
                    ("t P + d", (P, t, d) => t * P + d), ("t (P + d)", (P, t, d) => t * (P + d)),
                ]
                from shapes in (Affects[])[Affects.Circles, Affects.Triangles, Affects.Circles | Affects.Triangles]
                select ($"{Names(shapes)}: X = {X.Is}", OtherX(shapes, X.Of)))
            .Or("circle: neither t nor X with P", WithoutP(Affects.Circles))
            .Or("triangle: neither t nor X with P", WithoutP(Affects.Triangles))
            .Or("triangle: the corners' volumes without P",
                lab => lab.TriangleIs((triangle, d) => lab.TriangleByVolumes(triangle, d, from: Vector3.Zero)))
            .Or("sphere: L = C, without P", WithoutP(Affects.Spheres))
            .Or("sphere: b = −2 d·C, without P", lab => lab.InB.Is((P, C) => -C))
            .Or("sphere: b = 2 d·P, without C", lab => lab.InB.Is((P, C) => P))
            .Or("sphere: c = C² − R², without P", lab => lab.InC.Is((P, C) => C))
            .Or("sphere: c = P² − R², without C", lab => lab.InC.Is((P, C) => P))
            .Or("sphere: tca = C·d, without P, and D = L − tca d",
                lab => lab.Sphere.Is((s, d) => lab.Geometric(s, d, (L, tca) => L - tca * d, inTca: s.Center)))
            .Or("box: B0 / d and B1 / d, without P", WithoutP(Affects.Boxes))
            .Or("box: face by face, B0 / d and B1 / d without P, and X = P + t d",
                BoxMistakes.Crossed("xyz", (lo, hi, _, d) => (lo / d, hi / d)) + (lab => lab.AskFaces()))
            .Or("box: face by face, X = t d, without P", lab =>
            {
                lab.AskFaces();
                lab.FaceX.Is((t, d) => t * d);
            })
            .Or("box: B0 / d, without P", BoxMistakes.Crossed("xyz", (lo, hi, origin, d) => (lo / d, (hi - origin) / d)))
            .Or("box: B1 / d, without P", BoxMistakes.Crossed("xyz", (lo, hi, origin, d) => ((lo - origin) / d, hi / d)))
            .Or(from axis in (string[])["x", "y", "z"]
                select ($"box: without P, for {axis}", BoxMistakes.Crossed(axis, (lo, hi, _, d) => (lo / d, hi / d))))
            .Or("every shape: the ray starts at the origin of the world", WithoutP(Shapes)),
    ];

    /// <summary>Rays start at the near plane, and t is counted from P: another right way, in which a wrong t shows otherwise.</summary>
    public static (string Cause, Action<Lab> Deviate) FromNear => ("rays start at the near plane", StartAtNear);

    private static void StartAtNear(Lab lab)
    {
        lab.Plane.Becomes(cross => (plane, d) => From(Start(d), t => cross(plane with { Point = plane.Point - t * d }, d)));
        lab.Sphere.Becomes(cross => (sphere, d) => From(Start(d), t => cross(sphere with { Center = sphere.Center - t * d }, d)));

        double Start(Vector3 d) => lab.Camera.ZNear / (lab.Camera.Clip == ClipMode.Depth ? -(d * lab.W) : 1);

        Crossings<Scalar> From(double t, Func<double, Crossings<Scalar>> cross)
        {
            var crossed = cross(t);
            return new(crossed.Near + t, crossed.Far + t);
        }
    }

    private static string Names(Affects shapes) =>
        shapes == Affects.Circles ? "circle" : shapes == Affects.Triangles ? "triangle" : "circle and triangle";

    /// <summary>Another X, from P, t and d, where the radius or u and v are asked.</summary>
    private static Action<Lab> OtherX(Affects shapes, Func<Vector3, double, Vector3, Vector3> X) => lab =>
    {
        if (shapes.HasFlag(Affects.Circles))
        {
            lab.Circle.Becomes(cross => (circle, d) =>
            {
                var t = cross(circle with { Radius = double.PositiveInfinity }, d).Near;
                return (X(lab.P, (double)t, d) - circle.Center).Length <= circle.Radius ? new(t) : None;
            });
        }
        if (shapes.HasFlag(Affects.Triangles))
            lab.TriangleX.Is((t, d) => X(lab.P, t, d));
    };

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
