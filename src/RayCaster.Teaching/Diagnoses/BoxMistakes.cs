using static RayCaster.Teaching.SlideFormulas;

namespace RayCaster.Teaching;

/// <summary>In the formula of the box.</summary>
internal static class BoxMistakes
{
    private const double endless = double.PositiveInfinity;

    public static Mistake[] All =>
    [
        new("slab-noswap", Affects.Boxes, Slides.BoxParameters, "box: t0 and t1 not sorted, which is wrong where d is negative",
            Slabs(isSorted: false),
            "Boxes show from one side and vanish from another.",
            "Where d is negative, which face of a slab comes first?",
            "If t0 > t1, swap them, for each of x, y and z."),
        new("slab-minmin", Affects.Boxes, Slides.BoxTest, "box: t_min is the smallest entry parameter, not the largest",
            Slabs(lastIn: Least),
            "Boxes smear over the picture.",
            "The ray is in the box when it is in all three slabs. Has it entered at the first way in, or at the last?",
            "t_min = max of the ways in, t_max = min of the ways out."),
        new("slab-2axes", Affects.Boxes, Slides.BoxTest, "box: the slab of z forgotten",
            Corners(box => new(box.Min with { Z = -endless }, box.Max with { Z = endless })),
            "Boxes are endless columns.",
            "How many slabs make a box?",
            "Do the same for x, y and z."),
        new("slab-axis", Affects.Boxes, Slides.BoxParameters, "box: another axis in one slab: (B0.y − P.y) / d.x",
            Slabs(axesOfD: [0, 0, 2]),
            "Boxes are skewed, or too large along one axis.",
            "Each slab has one axis. Of which axis are B0, P and d in the t0 and t1 of each?",
            "t0 = (B0.y − P.y) / d.y for the slab of y, and so for x and z."),
        new("slab-tmax", Affects.Boxes, Slides.BoxTest, "box: t_max is returned, the way out",
            lab => lab.Box.Becomes(cross => (box, d) => new(cross(box, d).Far)),
            "Boxes look hollow and too dark: you see their far faces from inside.",
            "Which of t_min and t_max comes first?",
            "t = t_min, and t_max only if that does not count."),
        new Mistake("slab-inv-nan", Affects.Boxes, Slides.BoxParameters,
            "box: (B − P) · (1 / d) with d = 0 gives 0 · ∞, NaN, which loses the box",
            Slabs((lo, hi, P) => ((lo - P) * endless, (hi - P) * endless)),
            "A box lacks a line one pixel wide, at its edge or right through it.",
            "What is 0 · (1 / 0) in doubles?",
            "A ray along a slab is in it where lo ≤ origin ≤ hi, both ends included; test that where d = 0.")
            .Or("box: a ray along a slab, d = 0, misses it", Slabs((_, _, _) => (double.NaN, double.NaN)))
            .Or("box: a ray along a slab, d = 0, is always in it", Slabs((_, _, _) => (-endless, endless))),
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

    /// <summary>The slides' way: t_min is the largest entry parameter, t_max the smallest exit parameter.</summary>
    /// <param name="along">From the faces of a slab and P, the ways in and out of a ray along it; the right ones if null.</param>
    /// <param name="lastIn">From the ways in, the one that counts.</param>
    /// <param name="axesOfD">Which coordinate of d the slabs of x, y and z take.</param>
    private static Action<Lab> Slabs(Func<double, double, double, (double, double)>? along = null, bool isSorted = true,
        Func<double, double, double, double>? lastIn = null, int[]? axesOfD = null) => lab => lab.Box.Is((box, d) =>
    {
        var (x, y, z) = (SlabOf(0), SlabOf(1), SlabOf(2));
        var t_min = lastIn?.Invoke(x.In, y.In, z.In) ?? Math.Max(Math.Max(x.In, y.In), z.In);
        var t_max = Least(x.Out, y.Out, z.Out);
        return t_min <= t_max ? new(t_min, t_max) : None;

        (double In, double Out) SlabOf(int axis)
        {
            var (lo, hi, P) = (box.Min.At(axis), box.Max.At(axis), lab.P.At(axis));
            var b = d.At(axesOfD?[axis] ?? axis);
            var (t0, t1) = b != 0 ? ((lo - P) / b, (hi - P) / b)
                : along is not null ? along(lo, hi, P)
                : lo <= P && P <= hi ? (-endless, endless) : (double.NaN, double.NaN);
            return isSorted ? (Math.Min(t0, t1), Math.Max(t0, t1)) : (t0, t1);
        }
    });

    private static Action<Lab> Corners(Func<Aabb, Aabb> other) => lab => lab.Box.Becomes(cross => (box, d) => cross(other(box), d));
}
