using static RayCaster.Teaching.SlideFormulas;

namespace RayCaster.Teaching;

/// <summary>In the formula of the box.</summary>
internal static class BoxMistakes
{
    private const double endless = double.PositiveInfinity;

    public static Mistake[] All =>
    [
        new Mistake("slab-noswap", Affects.Boxes, Slides.BoxParameters, "box: t0 and t1 not sorted, which is wrong where d is negative",
            Unsorted("xyz"),
            "Boxes show from one side and vanish from another.",
            "Where d is negative, which face of a slab comes first?",
            "If t0 > t1, swap them, for each of x, y and z.")
            .Or(from axes in (string[])["x", "y", "z", "xy", "xz", "yz"] select ($"box: t0 and t1 not sorted for {axes}", Unsorted(axes)))
            .Or(from axes in (string[])["xyz", "x", "y", "z"]
                select ($"box: asked axis by axis, t0 and t1 not sorted for {axes}", Unsorted(axes) + AxisByAxis()))
            .Or("box: t0 and t1 always swapped", Ordered("xyz", (t0, t1) => (t1, t0)))
            .Or("box: t0 and t1 swapped where t0 < t1", Ordered("xyz", (t0, t1) => (Math.Max(t0, t1), Math.Min(t0, t1))))
            .Or(from axis in (string[])["x", "y", "z"]
                select ($"box: t0 and t1 swapped where t0 < t1, for {axis}", Ordered(axis, (t0, t1) => (Math.Max(t0, t1), Math.Min(t0, t1)))))
            .Or(from first in (bool[])[true, false]
                from axes in (string[])["xyz", "x", "y", "z"]
                select ($"box: only {(first ? "t0" : "t1")} changed where both should be swapped, for {axes}", Half(axes, first))),
        new Mistake("slab-minmin", Affects.Boxes, Slides.BoxTest, "box: t_min is the least way in, not the last",
            Folded(Least, Least),
            "Boxes smear over the picture.",
            "The ray is in the box when it is in all three slabs. Has it entered at the first way in, or at the last?",
            "t_min = max of the ways in, t_max = min of the ways out.")
            .Or("box: t_max is the last way out, not the first", Folded(Greatest, Greatest))
            .Or("box: t_min is the least way in, t_max the last way out", Folded(Least, Greatest))
            .Or("box: t_min is the least way out, t_max the last way in",
                Ordered("xyz", (t0, t1) => (Math.Max(t0, t1), Math.Min(t0, t1))) + Folded(Least, Greatest))
            .Or(Folds())
            .Or(from order in Orders
                from turned in (int[])[4, 8, 12, 16, 32, 48]
                select ($"box: asked axis by axis{order.Is}, with the other of min and max for {Names(turned)}",
                    AxisByAxis(order.Misses, turned: turned)))
            .Or(from order in Orders.Skip(1)
                from copied in (int[])[8, 32, 12, 48, 40, 60]
                select ($"box: asked axis by axis{order.Is}, with that of the axis alone for {Names(copied)}",
                    AxisByAxis(order.Misses, copied: copied)))
            .Or("box: t_min stays −∞", lab => lab.LastIn.Is((_, _, _) => -endless))
            .Or("box: t_max stays +∞", lab => lab.FirstOut.Is((_, _, _) => endless))
            .Or("box: t_min ≤ t_max is not asked", lab => lab.Overlap.Is((_, _) => true))
            .Or("box: t_max ≥ 0 asked, but not t_min ≤ t_max", lab => lab.Overlap.Is((_, tMax) => tMax >= 0))
            .Or("box: t_min > t_max asked where t_min ≤ t_max is meant", lab => lab.Overlap.Is((tMin, tMax) => tMin > tMax)),
        new Mistake("slab-2axes", Affects.Boxes, Slides.BoxTest, "box: the slab of z forgotten",
            Corners(box => new(box.Min with { Z = -endless }, box.Max with { Z = endless })),
            "Boxes are endless columns.",
            "How many slabs make a box?",
            "Do the same for x, y and z.")
            .Or("box: the slab of x forgotten", Corners(box => new(box.Min with { X = -endless }, box.Max with { X = endless })))
            .Or("box: the slab of y forgotten", Corners(box => new(box.Min with { Y = -endless }, box.Max with { Y = endless })))
            .Or(FaceSlips())
            .Or(AxisSlips())
            .Or(from left in (int[])[1, 2, 4, 8, 16, 32, 12, 48, 60]
                select ($"box: asked axis by axis, without {Names(left)}", AxisByAxis(left: left)))
            .Or(from order in Orders.Skip(1)
                from left in (int[])[4, 8, 16, 32, 12, 48, 60]
                select ($"box: asked axis by axis{order.Is}, without {Names(left)}", AxisByAxis(order.Misses, left))),
        new Mistake("slab-tmax", Affects.Boxes, Slides.BoxTest, "box: t_max is returned, the way out",
            lab => lab.Box.Becomes(cross => (box, d) => new(cross(box, d).Far)),
            "Boxes look hollow and too dark: you see their far faces from inside.",
            "Which of t_min and t_max comes first?",
            "t = t_min, and t_max only if that does not count.")
            .Or("box: t is the middle of t_min and t_max",
                lab => lab.Box.Becomes(cross => (box, d) => cross(box, d) is var crossed ? new(0.5 * (crossed.Near + crossed.Far)) : default))
            .Or("box: t_max is tried first, then t_min", lab => lab.Box.Becomes(cross => (box, d) => Turned(cross(box, d)))),
        new Mistake("slab-inv-nan", Affects.Boxes, Slides.BoxParameters,
            "box: (B − P) · (1 / d) with d = 0 gives 0 · ∞, NaN, which loses the box",
            Crossed("xyz", (lo, hi, origin, d) => ((lo - origin) * (1 / d), (hi - origin) * (1 / d))),
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
        new Mistake("box-size", Affects.Boxes, Slides.Box, "box: the second corner taken for its size, B1 = B0 + B1",
            Sized,
            "Boxes have a wrong size or place, or are gone.",
            "The scene's \"max\": is it a corner, or how far it is from corner to corner?",
            "B0 = min and B1 = max, as the scene has them.")
            .Or("box: the second corner taken for its size, t0 and t1 sorted by the sign of d", Sized + BySign)
            .Or("box: asked axis by axis, the second corner taken for its size", AxisByAxis() + Sized + BySign)
            .Or("box: face by face, the second corner taken for its size", Sized + (lab => lab.AskFaces()))
            .Or("box: the first corner taken for its middle, the second for its size",
                Corners(box => new(box.Min - 0.5 * box.Max, box.Min + 0.5 * box.Max)))
            .Or("box: the first corner taken for its middle, the second for half its size",
                Corners(box => new(box.Min - box.Max, box.Min + box.Max)))
            .Or("box: its size taken for half of it", Corners(box => new(1.5 * box.Min - 0.5 * box.Max, 1.5 * box.Max - 0.5 * box.Min)))
            .Or("box: half as large from its first corner on", Corners(box => new(box.Min, 0.5 * (box.Min + box.Max)))),
    ];

    private static Action<Lab> Sized => Corners(box => new(box.Min, box.Min + box.Max));

    private static Action<Lab> BySign => lab => lab.Order.Is((axis, t0, t1, d) => d.At(axis) < 0 ? (t1, t0) : (t0, t1));

    /// <summary>The ways into a slab and out of it, for a ray along it.</summary>
    private static Action<Lab> AlongASlab((double, double) ways) =>
        lab => lab.Faces.Becomes(faces => (axis, box, d) => d.At(axis) == 0 ? ways : faces(axis, box, d));

    /// <summary>What may be forgotten where each of the six faces is asked by itself.</summary>
    private static IEnumerable<(string, Action<Lab>)> FaceSlips() =>
    [
        ("box: face by face, only the next coordinate asked", lab => lab.AskFaces((axis, other) => other == (axis + 1) % 3)),
        ("box: face by face, only the coordinate before asked", lab => lab.AskFaces((axis, other) => other == (axis + 2) % 3)),
        ("box: face by face, only the first of the other coordinates asked", lab => lab.AskFaces((axis, other) => other == (axis == 0 ? 1 : 0))),
        ("box: face by face, only the last of the other coordinates asked", lab => lab.AskFaces((axis, other) => other == (axis == 2 ? 1 : 2))),
        .. from axis in (int[])[0, 1, 2]
           select ($"box: face by face, {"xyz"[axis]} not asked", (Action<Lab>)(lab => lab.AskFaces((_, other) => other != axis))),
        .. from axis in (int[])[2, 1, 0]
           select ($"box: face by face, the two faces across {"xyz"[axis]} forgotten",
               Crossed("xyz"[axis..(axis + 1)], (_, _, _, _) => (double.NaN, double.NaN)) + (lab => lab.AskFaces())),
    ];

    /// <summary>What may be forgotten of one axis, or stay of another one where its line was copied.</summary>
    private static IEnumerable<(string, Action<Lab>)> AxisSlips()
    {
        const string axes = "xyz";
        for (var axis = 0; axis < 3; axis++)
        {
            var i = axis;
            yield return ($"box: {axes[i]} alone in t_min and t_max", Alone(i, first: true, last: true));
            yield return ($"box: {axes[i]} alone in t_min", Alone(i, first: true, last: false));
            yield return ($"box: {axes[i]} alone in t_max", Alone(i, first: false, last: true));
            yield return ($"box: {axes[i]} forgotten in t_min", Slabs(i, slab => slab with { In = -endless }));
            yield return ($"box: {axes[i]} forgotten in t_max", Slabs(i, slab => slab with { Out = endless }));
            yield return ($"box: t_min with the way out of {axes[i]}", Slabs(i, slab => slab with { In = slab.Out }));
            yield return ($"box: t_max with the way in of {axes[i]}", Slabs(i, slab => slab with { Out = slab.In }));
            foreach (var k in (int[])[(i + 1) % 3, (i + 2) % 3])
            {
                yield return ($"box: t0 and t1 of {axes[i]} swapped where those of {axes[k]} should be", lab => lab.Order.Becomes(order =>
                    (axis, t0, t1, d) => axis != i ? order(axis, t0, t1, d) : d.At(k) < 0 ? (t1, t0) : (t0, t1)));
                foreach (var wrong in (string[])["d0 d1", "P0 P1", "d0", "P0", "d1", "P1", "B0", "B1", "B0 B1"])
                {
                    int Of(string letter) => wrong.Contains(letter) ? k : i;
                    var (B0, P0, d0, B1, P1, d1) = (Of("B0"), Of("P0"), Of("d0"), Of("B1"), Of("P1"), Of("d1"));
                    yield return ($"box: the slab of {axes[i]} with the {axes[k]} of {wrong} in (B0 − P0) / d0 and (B1 − P1) / d1",
                        lab => lab.Faces.Becomes(faces => (axis, box, d) => axis != i ? faces(axis, box, d)
                            : ((box.Min.At(B0) - lab.P.At(P0)) / d.At(d0), (box.Max.At(B1) - lab.P.At(P1)) / d.At(d1))));
                }
            }
        }
    }

    /// <summary>t_min or t_max or both are those of one axis, as where each axis overwrites the one before.</summary>
    private static Action<Lab> Alone(int axis, bool first, bool last) => lab => lab.Slab.Becomes(slab => (i, box, d) =>
        slab(i, box, d) is var (t0, t1) && i != axis ? (first ? -endless : t0, last ? endless : t1) : (t0, t1));

    /// <summary>What becomes of the slab of one axis.</summary>
    private static Action<Lab> Slabs(int axis, Func<(double In, double Out), (double, double)> other) => lab =>
        lab.Slab.Becomes(slab => (i, box, d) => i == axis ? other(slab(i, box, d)) : slab(i, box, d));

    /// <summary>Other ways into the slabs of some axes, such as "xz", and out of them, from t0 and t1.</summary>
    private static Action<Lab> Ordered(string axes, Func<double, double, (double, double)> other) => lab => lab.Order.Becomes(order =>
        (axis, t0, t1, d) => axes.Contains("xyz"[axis]) ? other(t0, t1) : order(axis, t0, t1, d));

    private static Action<Lab> Unsorted(string axes) => Ordered(axes, (t0, t1) => (t0, t1));

    /// <summary>Other t0 and t1 of some axes, from B0, B1, P and d.</summary>
    internal static Action<Lab> Crossed(string axes, Func<double, double, double, double, (double, double)> other) => lab =>
        lab.Faces.Becomes(faces => (axis, box, d) => axes.Contains("xyz"[axis])
            ? other(box.Min.At(axis), box.Max.At(axis), lab.P.At(axis), d.At(axis)) : faces(axis, box, d));

    /// <summary>t_min or t_max with another of Math.Min and Math.Max for two of the axes.</summary>
    private static IEnumerable<(string, Action<Lab>)> Folds() =>
        from fold in ((string Is, Func<double, double, double, double> Of)[])
        [
            ("max(x, min(y, z))", (x, y, z) => Math.Max(x, Math.Min(y, z))), ("min(x, max(y, z))", (x, y, z) => Math.Min(x, Math.Max(y, z))),
            ("max(min(x, y), z)", (x, y, z) => Math.Max(Math.Min(x, y), z)), ("min(max(x, y), z)", (x, y, z) => Math.Min(Math.Max(x, y), z)),
        ]
        from isIn in (bool[])[true, false]
        select ($"box: t_{(isIn ? "min" : "max")} = {fold.Is}", isIn ? Folded(fold.Of, Least) : Folded(Greatest, fold.Of));

    private static Action<Lab> Folded(Func<double, double, double, double> lastIn, Func<double, double, double, double> firstOut) =>
        lab =>
        {
            if (lastIn != Greatest) lab.LastIn.Is(lastIn);
            if (firstOut != Least) lab.FirstOut.Is(firstOut);
        };

    /// <summary>Where t0 &gt; t1, one of both gets the other's value and the other stays.</summary>
    private static Action<Lab> Half(string axes, bool first) => Ordered(axes, (t0, t1) => t0 <= t1 ? (t0, t1) : first ? (t1, t1) : (t0, t0));

    /// <summary>Whether a ray misses a box, from the way into and out of a slab, and from t_min and t_max with that slab in them.</summary>
    private delegate bool Misses(double t0, double t1, double tMin, double tMax);

    /// <summary>When it is asked whether the slabs overlap: all the same as long as t_min and t_max are right.</summary>
    private static (string Is, Misses? Misses)[] Orders =>
    [
        ("", null),
        (", t_min ≤ t_max last", (_, _, tMin, tMax) => tMin > tMax),
        (", t0 ≤ t_max and t_min ≤ t1 last", (t0, t1, tMin, tMax) => t0 > tMax || tMin > t1),
    ];

    /// <summary>The slide's way to ask: x first, then for y and for z whether they overlap with what there is, and what is left of it.</summary>
    /// <param name="misses">What is asked after t_min and t_max; the slide's question before them if null.</param>
    /// <param name="left">Of these six steps those that are left out: bits 0 and 1 are the questions, 2 and 3 t_min, 4 and 5 t_max.</param>
    /// <param name="turned">Those of the last four that take the lesser for the greater, or the greater for the lesser.</param>
    /// <param name="copied">Those of the last four that do not ask what there was before.</param>
    private static Action<Lab> AxisByAxis(Misses? misses = null, int left = 0, int turned = 0, int copied = 0) => lab => lab.Box.Is((box, d) =>
    {
        var (tMin, tMax) = lab.Slab.Do(0, box, d);
        for (var axis = 1; axis < 3; axis++)
        {
            var (t0, t1) = lab.Slab.Do(axis, box, d);
            if (misses is null && !Is(left, 1) && (tMin > t1 || t0 > tMax)) return None;
            if (!Is(left, 4)) tMin = Is(copied, 4) ? t0 : Is(turned, 4) ? Math.Min(tMin, t0) : Math.Max(tMin, t0);
            if (!Is(left, 16)) tMax = Is(copied, 16) ? t1 : Is(turned, 16) ? Math.Max(tMax, t1) : Math.Min(tMax, t1);
            if (misses?.Invoke(t0, t1, tMin, tMax) == true) return None;

            bool Is(int steps, int step) => (steps >> axis - 1 & step) != 0;
        }
        return new(tMin, tMax);
    });

    private static string Names(int left)
    {
        string[] steps = ["y asked", "z asked", "y in t_min", "z in t_min", "y in t_max", "z in t_max"];
        return string.Join(", ", steps.Where((_, i) => (left >> i & 1) != 0));
    }

    private static Action<Lab> Corners(Func<Aabb, Aabb> other) => lab => lab.Box.Becomes(cross => (box, d) => cross(other(box), d));
}
