using static RayCaster.Teaching.SlideFormulas;

namespace RayCaster.Teaching;

/// <summary>In the formula of the box.</summary>
internal static class BoxMistakes
{
    private const double endless = double.PositiveInfinity;

    public static Mistake[] All =>
    [
        new("slab-noswap", Affects.Boxes, Slides.BoxParameters, "box: t0 and t1 not sorted, which is wrong where d is negative",
            lab => lab.Order.Is((t0, t1) => (t0, t1)),
            "Boxes show from one side and vanish from another.",
            "Where d is negative, which face of a slab comes first?",
            "If t0 > t1, swap them, for each of x, y and z."),
        new("slab-minmin", Affects.Boxes, Slides.BoxTest, "box: t_min is the least way in, not the last",
            lab => lab.LastIn.Is(Least),
            "Boxes smear over the picture.",
            "The ray is in the box when it is in all three slabs. Has it entered at the first way in, or at the last?",
            "t_min = max of the ways in, t_max = min of the ways out."),
        new("slab-2axes", Affects.Boxes, Slides.BoxTest, "box: the slab of z forgotten",
            Corners(box => new(box.Min with { Z = -endless }, box.Max with { Z = endless })),
            "Boxes are endless columns.",
            "How many slabs make a box?",
            "Do the same for x, y and z."),
        new("slab-tmax", Affects.Boxes, Slides.BoxTest, "box: t_max is returned, the way out",
            lab => lab.Box.Becomes(cross => (box, d) => new(cross(box, d).Far)),
            "Boxes look hollow and too dark: you see their far faces from inside.",
            "Which of t_min and t_max comes first?",
            "t = t_min, and t_max only if that does not count."),
        new Mistake("slab-inv-nan", Affects.Boxes, Slides.BoxParameters,
            "box: (B − P) · (1 / d) with d = 0 gives 0 · ∞, NaN, which loses the box",
            lab => lab.Faces.Is((axis, box, d) =>
                ((box.Min.At(axis) - lab.P.At(axis)) * (1 / d.At(axis)), (box.Max.At(axis) - lab.P.At(axis)) * (1 / d.At(axis)))),
            "A box lacks a line one pixel wide, at its edge or right through it.",
            "What is 0 · (1 / 0) in doubles?",
            "A ray along a slab is in it where lo ≤ origin ≤ hi, both ends included; ask that where d = 0.")
            .Or("box: a ray along a slab, d = 0, misses it", AlongASlab((double.NaN, double.NaN)))
            .Or("box: a ray along a slab, d = 0, is always in it", AlongASlab((double.NegativeInfinity, double.PositiveInfinity))),
        new Mistake("slab-inside", Affects.Boxes, Slides.BoxTest, "box: t_min or none, so that it is not seen from inside",
            lab => lab.Box.Becomes(cross => (box, d) => new(cross(box, d).Near)),
            "A box that the camera is in, or that is cut open, is not there.",
            "From inside, what is the sign of t_min?",
            "Where t_min does not count, try t_max.")
            .Or("box: no hit where t_min < 0", lab => lab.Box.Becomes(cross => (box, d) => UnlessBehind(cross(box, d)))),
        new("box-size", Affects.Boxes, Slides.Box, "box: the second corner taken for its size, B1 = B0 + B1",
            Corners(box => new(box.Min, box.Min + box.Max)),
            "Boxes have a wrong size or place, or are gone.",
            "The scene's \"max\": is it a corner, or how far it is from corner to corner?",
            "B0 = min and B1 = max, as the scene has them."),
    ];

    /// <summary>The ways into a slab and out of it, for a ray along it.</summary>
    private static Action<Lab> AlongASlab((double, double) ways) =>
        lab => lab.Faces.Becomes(faces => (axis, box, d) => d.At(axis) == 0 ? ways : faces(axis, box, d));

    private static Action<Lab> Corners(Func<Aabb, Aabb> other) => lab => lab.Box.Becomes(cross => (box, d) => cross(other(box), d));
}
