using static RayCaster.Teaching.SlideFormulas;

namespace RayCaster.Teaching;

/// <summary>In the formula of a shape.</summary>
internal static class ShapeMistakes
{
    public static Mistake[] All => [.. OfSpheres, .. OfPlanes, .. OfBoxes, .. OfCircles, .. OfTriangles];

    private static Mistake[] OfSpheres =>
    [
        new("r-nosq", Concerns.Spheres, Slides.Sphere, "sphere: R where R² is meant",
            lab => lab.Sphere.Becomes(cross => (s, d) => cross(s with { Radius = Math.Sqrt(s.Radius) }, d)))
        {
            Hint = new("Spheres have a wrong size; one of radius 1 is right.",
                "Are both sides of your equation squares?",
                "thc = √(R² − D²)."),
        },
        new("disc-nan", Concerns.Spheres, Slides.Sphere, "sphere: the root of a negative number is taken, and NaN passes for a hit",
            lab =>
            {
                lab.Hit.Becomes(hit => (model, d) =>
                    model is Model<Sphere> s && double.IsNaN(lab.Sphere.Do(s.Primitive, d).Near) ? double.NaN : hit(model, d));
                lab.Better.Becomes(_ => (t, best) => !(t >= best)); // the same for numbers
            })
        {
            Hint = new("Nearly all is black where a sphere is in the scene; only what is listed after it survives.",
                "What does Math.Sqrt give for −1, and what does NaN < 0 say?",
                "Return no hit where R² − D² < 0, before the root."),
        },
        new("far-root", Concerns.Spheres, Slides.Sphere, "sphere: the far root t = tca + thc is taken",
            lab => lab.Sphere.Becomes(cross => (s, d) => new(cross(s, d).Far)))
        {
            Hint = new("Spheres look hollow: you see the inside of their far half.",
                "Which of tca − thc and tca + thc comes first?",
                "t = tca − thc, and tca + thc only if that does not count."),
        },
        new("near-root-only", Concerns.Spheres, Slides.Sphere, "sphere: the near root t = tca − thc or none",
            lab => lab.Sphere.Becomes(cross => (s, d) => new(cross(s, d).Near)))
        {
            Hint = new("A sphere that the camera is in, or that is cut open, is not there.",
                "From inside, what is the sign of tca − thc?",
                "Where tca − thc does not count, try tca + thc."),
        },
        new("oc-sign", Concerns.Spheres, Slides.Sphere, "sphere: P − C where C − P is meant, which mirrors the sphere at the camera",
            lab => lab.Sphere.Becomes(cross => (s, d) => cross(s with { Center = 2 * lab.P - s.Center }, d)))
        {
            Hint = new("Spheres are missing; those behind the camera show.",
                "From where to where does L point?",
                "L = C − P, tca = L·d. (In the quadratic: b = 2 d·(P − C).)"),
        },
        new Mistake("disc-2", Concerns.Spheres, Slides.Sphere, "sphere: discriminant b² − a c, while b = 2 d·(P − C) has its 2",
            lab => lab.Sphere.Becomes(_ => (s, d) => Quadratic(lab, s, d, (b, c) => Roots(1, b, b * b - c))))
        {
            Rewrites = true,
            Hint = new("Spheres bleed over the picture.",
                "Is the discriminant b² − 4ac or (b/2)² − ac? Which one fits your b?",
                "With b = 2 d·(P − C): b² − 4ac and t = (−b ∓ √…) / 2a."),
        }
        .Or("sphere: b = d·(P − C) without its 2, while the discriminant is b² − 4 a c",
            lab => lab.Sphere.Becomes(_ => (s, d) => Quadratic(lab, s, d, (b, c) => Roots(1, b / 2, b * b / 4 - 4 * c)))),
    ];

    private static Mistake[] OfPlanes =>
    [
        new Mistake("plane-sign", Concerns.Planes | Concerns.Circles, Slides.Plane, "plane: (P − Q)·n, so that t has the wrong sign",
            lab => lab.Plane.Becomes(cross => (plane, d) => Mirrored(cross(plane, d))))
        {
            Hint = new("Planes are missing; those behind the camera may show.",
                "A plane before the camera: is your t positive?",
                "t = (Q − P)·n / d·n."),
        }
        .Or("plane and circle: (P − Q)·n, so that t has the wrong sign",
            lab =>
            {
                lab.Plane.Becomes(cross => (plane, d) => Mirrored(cross(plane, d)));
                lab.Circle.Becomes(cross => (circle, d) => cross(circle with { Center = 2 * lab.P - circle.Center }, d));
            }),
        new Mistake("plane-cull", Concerns.Planes | Concerns.Circles, Slides.Plane, "plane: left out where n points away from the camera (d·n ≥ 0)",
            lab => lab.Plane.Becomes(cross => (plane, d) => d * plane.Normal >= 0 ? None : cross(plane, d)))
        {
            Hint = new("Some planes are missing; they come back when n is turned round.",
                "Does the slide say anything of the sign of d·n?",
                "Only d·n = 0 has no crossing; both sides are visible."),
        }
        .Or("plane: left out where n points to the camera (d·n ≤ 0)",
            lab => lab.Plane.Becomes(cross => (plane, d) => d * plane.Normal <= 0 ? None : cross(plane, d)))
        .Or("plane and circle: left out where n points away from the camera (d·n ≥ 0)",
            lab =>
            {
                lab.Plane.Becomes(cross => (plane, d) => d * plane.Normal >= 0 ? None : cross(plane, d));
                lab.Circle.Becomes(cross => (circle, d) => d * circle.Normal >= 0 ? None : cross(circle, d));
            }),
    ];

    private static Mistake[] OfBoxes =>
    [
        new("slab-noswap", Concerns.Boxes, Slides.Box, "box: t0 and t1 not sorted, which is wrong where d is negative",
            lab => lab.Box.Becomes(_ => (box, d) => Slabs(lab, box, d, (lo, hi, origin, direction) => direction == 0
                ? AlongSlab(lo, hi, origin)
                : ((lo - origin) / direction, (hi - origin) / direction), Math.Max, Math.Min)))
        {
            Rewrites = true,
            Hint = new("Boxes show from one side and vanish from another.",
                "Where d is negative, which face of a slab comes first?",
                "If t0 > t1, swap them, for each of x, y and z."),
        },
        new Mistake("slab-minmin", Concerns.Boxes, Slides.Box, "box: t_min is the least way in, not the last",
            lab => lab.Box.Becomes(_ => (box, d) => Slabs(lab, box, d, Slab, Math.Min, Math.Min)))
        {
            Rewrites = true,
            Hint = new("Boxes smear over the picture.",
                "The ray is in the box when it is in all three slabs. Has it entered at the first way in, or at the last?",
                "t_min = max of the ways in, t_max = min of the ways out."),
        }
        .Or("box: t_max is the last way out, not the first",
            lab => lab.Box.Becomes(_ => (box, d) => Slabs(lab, box, d, Slab, Math.Max, Math.Max))),
        new Mistake("slab-2axes", Concerns.Boxes, Slides.Box, "box: the slab of z forgotten", lab => lab.Box.Becomes(cross => (box, d) =>
            cross(new(box.Min with { Z = double.NegativeInfinity }, box.Max with { Z = double.PositiveInfinity }), d)))
        {
            Hint = new("Boxes are endless columns.",
                "How many slabs make a box?",
                "Do the same for x, y and z."),
        }
        .Or("box: the slab of x forgotten", lab => lab.Box.Becomes(cross => (box, d) =>
            cross(new(box.Min with { X = double.NegativeInfinity }, box.Max with { X = double.PositiveInfinity }), d)))
        .Or("box: the slab of y forgotten", lab => lab.Box.Becomes(cross => (box, d) =>
            cross(new(box.Min with { Y = double.NegativeInfinity }, box.Max with { Y = double.PositiveInfinity }), d))),
        new("slab-tmax", Concerns.Boxes, Slides.Box, "box: t_max is returned, the way out",
            lab => lab.Box.Becomes(cross => (box, d) => new(cross(box, d).Far)))
        {
            Hint = new("Boxes look hollow and too dark: you see their far faces from inside.",
                "Which of t_min and t_max comes first?",
                "t = t_min, and t_max only if that does not count."),
        },
        new("slab-inv-nan", Concerns.Boxes, Slides.Box, "box: (B − P) · (1 / d) with d = 0 gives 0 · ∞, NaN, which loses the box",
            lab => lab.Box.Becomes(_ => (box, d) => Slabs(lab, box, d, (lo, hi, origin, direction) =>
                Sorted((lo - origin) * (1 / direction), (hi - origin) * (1 / direction)), Math.Max, Math.Min)))
        {
            Rewrites = true,
            Hint = new("A box lacks a line one pixel wide, at its edge or right through it.",
                "What is 0 · (1 / 0) in doubles?",
                "A ray along a slab is in it where lo ≤ origin ≤ hi, both ends included; ask that where d = 0."),
        },
        new("slab-inside", Concerns.Boxes, Slides.Box, "box: t_min or none, so that it is not seen from inside",
            lab => lab.Box.Becomes(cross => (box, d) => new(cross(box, d).Near)))
        {
            Hint = new("A box that the camera is in, or that is cut open, is not there.",
                "From inside, what is the sign of t_min?",
                "Where t_min does not count, try t_max."),
        },
    ];

    private static Mistake[] OfCircles =>
    [
        new("circ-nosq", Concerns.Circles, Slides.Circle, "circle: |X − C|² ≤ R",
            lab => lab.Circle.Becomes(cross => (circle, d) => cross(circle with { Radius = Math.Sqrt(circle.Radius) }, d)))
        {
            Hint = new("Circles have a wrong size; one of radius 1 is right.",
                "Are both sides of your comparison lengths, or both squares?",
                "|X − C| ≤ R, or |X − C|² ≤ R²."),
        },
        new("circ-inf", Concerns.Circles, Slides.Circle, "circle: the radius is not asked",
            lab => lab.Circle.Becomes(cross => (circle, d) => cross(circle with { Radius = double.PositiveInfinity }, d)))
        {
            Hint = new("A circle covers the picture like an endless plane.",
                "What is there of a circle that a plane has not?",
                "The plane's crossing X counts only where |X − C| ≤ R."),
        },
    ];

    private static Mistake[] OfTriangles =>
    [
        new Mistake("tri-uv", Concerns.Triangles, Slides.Triangle, "triangle: u ≥ 0 and v ≥ 0, but no u + v ≤ 1: an endless wedge",
            lab => TriangleWhere(lab, (u, v) => u >= 0 && v >= 0))
        {
            Rewrites = true,
            Hint = new("Triangles reach beyond the side that is opposite to their first corner.",
                "Which condition draws the side from B to C?",
                "u ≥ 0, v ≥ 0, u + v ≤ 1."),
        }
        .Or("triangle: u ≤ 1 and v ≤ 1 where u + v ≤ 1 is meant: a parallelogram",
            lab => TriangleWhere(lab, (u, v) => u is >= 0 and <= 1 && v is >= 0 and <= 1)),
        new Mistake("tri-cull", Concerns.Triangles, Slides.Triangle, "triangle: left out where its corners run clockwise (d·n ≥ 0)",
            lab => lab.Triangle.Becomes(cross => (triangle, d) => d * NormalOf(lab, triangle) >= 0 ? None : cross(triangle, d)))
        {
            Hint = new("Some triangles are missing; they come back when two corners are swapped.",
                "Does the slide say anything of the sign of d·n?",
                "Only d·n = 0 has no crossing; both sides are visible."),
        }
        .Or("triangle: left out where its corners run counter-clockwise (d·n ≤ 0)",
            lab => lab.Triangle.Becomes(cross => (triangle, d) => d * NormalOf(lab, triangle) <= 0 ? None : cross(triangle, d))),
        new("tri-neg", Concerns.Triangles, Slides.Triangle, "triangle: u + v ≤ 1, but neither u ≥ 0 nor v ≥ 0: a half-plane",
            lab => TriangleWhere(lab, (u, v) => u + v <= 1))
        {
            Rewrites = true,
            Hint = new("A triangle covers half of the picture.",
                "Which conditions draw the two sides at A?",
                "u ≥ 0, v ≥ 0, u + v ≤ 1."),
        },
        new Mistake("tri-area", Concerns.Triangles, Slides.Triangle, "triangle: the sum of the three areas compared with ==",
            lab => lab.Triangle.Becomes(_ => (triangle, d) => TriangleByAreas(lab, triangle, d)))
        {
            Rewrites = true,
            Hint = new("Triangles are full of holes, like lace.",
                "Is 0.1 + 0.2 equal to 0.3 in doubles?",
                "u ≥ 0, v ≥ 0, u + v ≤ 1: no sums that must be equal to the last bit."),
        }
        .Or("triangle: the sum of the three areas compared with ==, in other numbers or another order, which loses other pixels",
            lab =>
            {
                lab.Triangle.Becomes(_ => (_, _) => None);
                lab.Scatters = true;
            }),
    ];

    /// <summary>Slide "Sphere – Analytic Solution" for d·d = 1, with b = 2 d·(P − C) and c = |P − C|² − R².</summary>
    private static Crossings<Scalar> Quadratic(Lab lab, Sphere s, Vector3 d, Func<double, double, Crossings<Scalar>> roots)
    {
        var CP = lab.P - s.Center;
        return roots(2 * (d * CP), CP * CP - s.Radius * s.Radius);
    }

    private static void TriangleWhere(Lab lab, Func<double, double, bool> inside)
    {
        lab.Triangle.Becomes(_ => (triangle, d) => SlideFormulas.Triangle(lab, triangle, d, inside));
        lab.TrianglesReachOut = true;
    }

    private static Vector3 NormalOf(Lab lab, Triangle triangle) => lab.Cross.Do(triangle.B - triangle.A, triangle.C - triangle.A);
}
