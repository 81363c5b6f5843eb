using static RayCaster.Teaching.SlideFormulas;

namespace RayCaster.Teaching;

/// <summary>In the formula of the box.</summary>
internal static class BoxMistakes
{
    public static Mistake[] All =>
    [
        new Mistake("slab-noswap", Concerns.Boxes, Slides.BoxParameters, "box: t0 and t1 not sorted, which is wrong where d is negative",
            Unsorted("xyz"),
            "Boxes show from one side and vanish from another.",
            "Where d is negative, which face of a slab comes first?",
            "If t0 > t1, swap them, for each of x, y and z.")
            .Or(from axes in (string[])["x", "y", "z", "xy", "xz", "yz"] select ($"box: t0 and t1 not sorted for {axes}", Unsorted(axes)))
            .Or(from axis in (int[])[0, 1, 2]
                from of in (int[])[0, 1, 2]
                where of != axis
                select ($"box: t0 and t1 of {"xyz"[axis]} swapped where those of {"xyz"[of]} should be",
                    One(axis, (box, P, d, _) => ByAxis(box, P, d, axis, of))))
            .Or("box: t0 and t1 always swapped", Each((lo, hi, origin, d) => Faces(lo, hi, origin, d) is var (t0, t1) ? (t1, t0) : default))
            .Or(from axis in (int[])[-1, 0, 1, 2] select ($"box: only t0 changed where both should be swapped{Of(axis)}", Half(axis, first: true)))
            .Or(from axis in (int[])[-1, 0, 1, 2] select ($"box: only t1 changed where both should be swapped{Of(axis)}", Half(axis, first: false))),
        new Mistake("slab-minmin", Concerns.Boxes, Slides.BoxTest, "box: t_min is the least way in, not the last",
            lab => lab.Box.Is((box, d) => Slabs(lab, box, d, Slab, Math.Min, Math.Min)),
            "Boxes smear over the picture.",
            "The ray is in the box when it is in all three slabs. Has it entered at the first way in, or at the last?",
            "t_min = max of the ways in, t_max = min of the ways out.")
            .Or("box: t_max is the last way out, not the first", lab => lab.Box.Is((box, d) => Slabs(lab, box, d, Slab, Math.Max, Math.Max)))
            .Or("box: t_min is the least way in, t_max the last way out",
                lab => lab.Box.Is((box, d) => Slabs(lab, box, d, Slab, Math.Min, Math.Max)))
            .Or("box: t_min is the least way out, t_max the last way in", lab => lab.Box.Is((box, d) => Slabs(lab, box, d,
                (lo, hi, origin, direction) => Slab(lo, hi, origin, direction) is var (t0, t1) ? (t1, t0) : default, Math.Min, Math.Max)))
            .Or(Folds())
            .Or(from axis in (int[])[0, 1, 2] select ($"box: the way out for the way in, for {"xyz"[axis]} in t_min", One(axis, (_, _, _, slab) => slab with { In = slab.Out })))
            .Or(from axis in (int[])[0, 1, 2] select ($"box: the way in for the way out, for {"xyz"[axis]} in t_max", One(axis, (_, _, _, slab) => slab with { Out = slab.In })))
            .Or("box: t_min ≤ t_max is not asked", Asked((_, _) => true))
            .Or("box: t_min > t_max asked where t_min ≤ t_max is meant", Asked((tMin, tMax) => tMin > tMax)),
        new Mistake("slab-2axes", Concerns.Boxes, Slides.BoxTest, "box: the slab of z forgotten", lab => lab.Box.Becomes(cross => (box, d) =>
            cross(new(box.Min with { Z = double.NegativeInfinity }, box.Max with { Z = double.PositiveInfinity }), d)),
            "Boxes are endless columns.",
            "How many slabs make a box?",
            "Do the same for x, y and z.")
            .Or("box: the slab of x forgotten", lab => lab.Box.Becomes(cross => (box, d) =>
                cross(new(box.Min with { X = double.NegativeInfinity }, box.Max with { X = double.PositiveInfinity }), d)))
            .Or("box: the slab of y forgotten", lab => lab.Box.Becomes(cross => (box, d) =>
                cross(new(box.Min with { Y = double.NegativeInfinity }, box.Max with { Y = double.PositiveInfinity }), d)))
            .Or(AxisSlips())
            .Or(from left in (int[])[1, 2, 4, 8, 16, 32, 12, 48, 60] select ($"box: asked axis by axis, without {Names(left)}", AxisByAxis(left))),
        new Mistake("slab-tmax", Concerns.Boxes, Slides.BoxTest, "box: t_max is returned, the way out",
            lab => lab.Box.Becomes(cross => (box, d) => new(cross(box, d).Far)),
            "Boxes look hollow and too dark: you see their far faces from inside.",
            "Which of t_min and t_max comes first?",
            "t = t_min, and t_max only if that does not count.")
            .Or("box: t_max is tried first, then t_min", lab => lab.Box.Becomes(cross => (box, d) => Turned(cross(box, d)))),
        new("slab-inv-nan", Concerns.Boxes, Slides.BoxParameters, "box: (B − P) · (1 / d) with d = 0 gives 0 · ∞, NaN, which loses the box",
            lab => lab.Box.Is((box, d) => Slabs(lab, box, d, (lo, hi, origin, direction) =>
                Sorted((lo - origin) * (1 / direction), (hi - origin) * (1 / direction)), Math.Max, Math.Min)),
            "A box lacks a line one pixel wide, at its edge or right through it.",
            "What is 0 · (1 / 0) in doubles?",
            "A ray along a slab is in it where lo ≤ origin ≤ hi, both ends included; ask that where d = 0."),
        new("slab-inside", Concerns.Boxes, Slides.BoxTest, "box: t_min or none, so that it is not seen from inside",
            lab => lab.Box.Becomes(cross => (box, d) => new(cross(box, d).Near)),
            "A box that the camera is in, or that is cut open, is not there.",
            "From inside, what is the sign of t_min?",
            "Where t_min does not count, try t_max."),
        new Mistake("box-size", Concerns.Boxes, Slides.Box, "box: the second corner taken for its size, B1 = B0 + B1",
            Corners(box => new(box.Min, box.Min + box.Max)),
            "Boxes have a wrong size or place, or are gone.",
            "The scene's \"max\": is it a corner, or how far it is from corner to corner?",
            "B0 = min and B1 = max, as the scene has them.")
            .Or("box: the first corner taken for its middle, the second for its size",
                Corners(box => new(box.Min - 0.5 * box.Max, box.Min + 0.5 * box.Max)))
            .Or("box: the first corner taken for its middle, the second for half its size",
                Corners(box => new(box.Min - box.Max, box.Min + box.Max)))
            .Or("box: the first corner taken for its middle", Corners(box => new(1.5 * box.Min - 0.5 * box.Max, 0.5 * (box.Min + box.Max))))
            .Or("box: half as large from its first corner on", Corners(box => new(box.Min, 0.5 * (box.Min + box.Max))))
            .Or("box: from its middle on as large as it is", Corners(box => new(0.5 * (box.Min + box.Max), 1.5 * box.Max - 0.5 * box.Min))),
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
            yield return ($"box: {axes[i]} forgotten in t_min", One(i, (_, _, _, slab) => slab with { In = double.NegativeInfinity }));
            yield return ($"box: {axes[i]} forgotten in t_max", One(i, (_, _, _, slab) => slab with { Out = double.PositiveInfinity }));
            foreach (var k in (int[])[(i + 1) % 3, (i + 2) % 3])
            {
                yield return ($"box: the slab of {axes[i]} divided by the {axes[k]} of d",
                    One(i, (box, P, d, _) => Slab(box.Min.At(i), box.Max.At(i), P.At(i), d.At(k))));
                yield return ($"box: the slab of {axes[i]} with the {axes[k]} of P",
                    One(i, (box, P, d, _) => Slab(box.Min.At(i), box.Max.At(i), P.At(k), d.At(i))));
                foreach (var (dk0, pk0, dk1, pk1) in ((int, int, int, int)[])[(k, i, i, i), (i, k, i, i), (i, i, k, i), (i, i, i, k)])
                {
                    var letter = axes[k] + (dk0 == k || dk1 == k ? " of d in t" : " of P in t") + (dk0 == k || pk0 == k ? "0" : "1");
                    yield return ($"box: the slab of {axes[i]} with the {letter}", One(i, (box, P, d, _) =>
                        Sorted((box.Min.At(i) - P.At(pk0)) / d.At(dk0), (box.Max.At(i) - P.At(pk1)) / d.At(dk1))));
                }
                yield return ($"box: the slab of {axes[i]} with the {axes[k]} of B0",
                    One(i, (box, P, d, _) => Slab(box.Min.At(k), box.Max.At(i), P.At(i), d.At(i))));
                yield return ($"box: the slab of {axes[i]} with the {axes[k]} of B1",
                    One(i, (box, P, d, _) => Slab(box.Min.At(i), box.Max.At(k), P.At(i), d.At(i))));
                yield return ($"box: the slab of {axes[i]} with the {axes[k]} of B0 and B1",
                    One(i, (box, P, d, _) => Slab(box.Min.At(k), box.Max.At(k), P.At(i), d.At(i))));
            }
        }
    }

    /// <summary>Another slab of one axis, from the box, P, d and the right slab.</summary>
    internal static Action<Lab> One(int axis, Func<Aabb, Vector3, Vector3, (double In, double Out), (double In, double Out)> slab) => lab =>
        lab.Box.Is((box, d) =>
        {
            InSlab other = (lo, hi, origin, direction) => slab(box, lab.P, d, Slab(lo, hi, origin, direction));
            return Slabs(lab, box, d, (axis == 0 ? other : Slab, axis == 1 ? other : Slab, axis == 2 ? other : Slab), Math.Max, Math.Min);
        });

    /// <summary>t_min or t_max or both are those of one axis, as where each axis overwrites the one before.</summary>
    private static Action<Lab> Alone(int axis, bool first, bool last) => lab => lab.Box.Is((box, d) =>
    {
        InSlab other = (lo, hi, origin, direction) => Slab(lo, hi, origin, direction) is var (t0, t1)
            ? (first ? double.NegativeInfinity : t0, last ? double.PositiveInfinity : t1) : default;
        return Slabs(lab, box, d, (axis == 0 ? Slab : other, axis == 1 ? Slab : other, axis == 2 ? Slab : other), Math.Max, Math.Min);
    });

    /// <summary>t_min and t_max each with another of Math.Min and Math.Max, for the first or for the last two axes.</summary>
    private static IEnumerable<(string, Action<Lab>)> Folds()
    {
        foreach (var (inner, outer, names) in ((Func<double, double, double>, Func<double, double, double>, string)[])
            [(Math.Min, Math.Max, "max(x, min(y, z))"), (Math.Max, Math.Min, "min(x, max(y, z))")])
        {
            foreach (var first in (bool[])[false, true])
            {
                double Fold(double x, double y, double z) => first ? outer(inner(x, y), z) : outer(x, inner(y, z));
                var how = first ? names + " with z for x" : names;
                yield return ($"box: t_min = {how}", lab => lab.Box.Is((box, d) => Folded(lab, box, d, Fold, (x, y, z) => Math.Min(x, Math.Min(y, z)))));
                yield return ($"box: t_max = {how}", lab => lab.Box.Is((box, d) => Folded(lab, box, d, (x, y, z) => Math.Max(x, Math.Max(y, z)), Fold)));
            }
        }
    }

    private static Crossings<Scalar> Folded(Lab lab, Aabb box, Vector3 d, Func<double, double, double, double> lastIn, Func<double, double, double, double> firstOut)
    {
        var slabs = (int[])[0, 1, 2];
        (double In, double Out)[] ways = [.. slabs.Select(i => Slab(box.Min.At(i), box.Max.At(i), lab.P.At(i), d.At(i)))];
        var (tMin, tMax) = (lastIn(ways[0].In, ways[1].In, ways[2].In), firstOut(ways[0].Out, ways[1].Out, ways[2].Out));
        return tMin <= tMax ? new(tMin, tMax) : None;
    }

    /// <summary>Where t0 &gt; t1, one of both gets the other's value and the other stays; for one axis, or with −1 for all.</summary>
    private static Action<Lab> Half(int axis, bool first) => lab => lab.Box.Is((box, d) =>
    {
        InSlab half = (lo, hi, origin, direction) => Faces(lo, hi, origin, direction) is var (t0, t1) && t0 <= t1 ? (t0, t1)
            : first ? (t1, t1) : (t0, t0);
        return Slabs(lab, box, d, (axis is 0 or -1 ? half : Slab, axis is 1 or -1 ? half : Slab, axis is 2 or -1 ? half : Slab), Math.Max, Math.Min);
    });

    /// <summary>The slide's way to ask: x first, then for y and for z whether they overlap with what there is, and what is left of it.</summary>
    /// <param name="left">Of these six steps those that are left out: bits 0 and 1 are the questions, 2 and 3 t_min, 4 and 5 t_max.</param>
    private static Action<Lab> AxisByAxis(int left) => lab => lab.Box.Is((box, d) =>
    {
        var (tMin, tMax) = Slab(box.Min.X, box.Max.X, lab.P.X, d.X);
        for (var axis = 1; axis < 3; axis++)
        {
            var (t0, t1) = Slab(box.Min.At(axis), box.Max.At(axis), lab.P.At(axis), d.At(axis));
            var steps = left >> axis - 1;
            if ((steps & 1) == 0 && (tMin > t1 || t0 > tMax)) return None;
            if ((steps & 4) == 0) tMin = Math.Max(tMin, t0);
            if ((steps & 16) == 0) tMax = Math.Min(tMax, t1);
        }
        return new(tMin, tMax);
    });

    /// <summary>A slab's t0 and t1 in the order of another one's.</summary>
    private static (double, double) ByAxis(Aabb box, Vector3 P, Vector3 d, int axis, int of) =>
        Faces(box.Min.At(axis), box.Max.At(axis), P.At(axis), d.At(axis)) is var (t0, t1) && d.At(of) < 0 ? (t1, t0) : (t0, t1);

    private static string Names(int left)
    {
        string[] steps = ["y asked", "z asked", "y in t_min", "z in t_min", "y in t_max", "z in t_max"];
        return string.Join(", ", steps.Where((_, i) => (left >> i & 1) != 0));
    }

    private static string Of(int axis) => axis < 0 ? "" : $", for {"xyz"[axis]}";

    /// <summary>Another slab of each axis.</summary>
    private static Action<Lab> Each(InSlab slab) => lab => lab.Box.Is((box, d) => Slabs(lab, box, d, slab, Math.Max, Math.Min));

    /// <summary>Another question about t_min and t_max than t_min ≤ t_max.</summary>
    private static Action<Lab> Asked(Func<double, double, bool> isHit) => lab => lab.Box.Is((box, d) =>
        Slabs(lab, box, d, (Slab, Slab, Slab), Math.Max, Math.Min, isHit));

    private static Action<Lab> Corners(Func<Aabb, Aabb> other) => lab => lab.Box.Becomes(cross => (box, d) => cross(other(box), d));

    /// <summary>The first way in is the lower face's for these axes, whichever way the ray goes.</summary>
    private static Action<Lab> Unsorted(string axes) => lab =>
        lab.Box.Is((box, d) => Slabs(lab, box, d,
            (axes.Contains('x') ? Faces : Slab, axes.Contains('y') ? Faces : Slab, axes.Contains('z') ? Faces : Slab), Math.Max, Math.Min));
}
