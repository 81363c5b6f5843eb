namespace RayCaster.Teaching;

/// <summary>Which crossing counts, and which hit shows.</summary>
internal static class HitMistakes
{
    public static Mistake[] All =>
    [
        new Mistake("no-t0", Affects.Hit, Slides.Bias, "no least t at all: what lies behind the camera shows",
            Bias(double.NegativeInfinity),
            "Things from behind the camera are in the picture, upside down and glaring.",
            "Where on the ray is a point with t = −3?",
            "A crossing counts only if t > bias, and from zNear on.")
            .Or(OfSome("no least t", (lab, t, depth) => lab.Far.Do(t, depth)))
            .Or("no test of t at all: neither t > bias nor zNear and zFar", lab =>
            {
                lab.Ahead.Is(t => t > double.NegativeInfinity);
                lab.Clipped.Is((t, _) => t <= double.MaxValue);
            })
            .Or("|t| for planes", lab => lab.Plane.Becomes(cross => (plane, d) => new(Math.Abs(cross(plane, d).Near)))),
        new Mistake("last-hit", Affects.Hit, Slides.RayCasting, "the last model hit shows, not the nearest",
            lab => lab.Better.Is((_, _) => true),
            "Far things cover near ones; the order of the models changes the picture.",
            "When may a hit replace the one that was found before? Do all models get the same ray?",
            "Keep a hit only if its t is less than the best t so far.")
            .Or("the last hit shows, of both crossings of a sphere or a box, too", Both + (lab => lab.Better.Is((_, _) => true)))
            .Or("the first model hit shows, not the nearest", lab => lab.Better.Is((_, best) => double.IsPositiveInfinity(best)))
            .Or(Either("the best t is replaced by that of each hit: the braces of the if are missing", lab => lab.Replaces.Is((_, _) => true)))
            .Or(Either("each t is compared with that of the hit before it", lab =>
            {
                lab.Replaces.Is((_, _) => true);
                lab.Lights.Is(lab.Better.Do);
            }))
            .Or(Either("the colour is computed from the t of the last hit, not of the nearest", lab => lab.Lights.Is((_, _) => true)))
            .Or("the model stays that of the first hit, the best t becomes the least", lab =>
            {
                lab.Replaces.Is((t, best) => t < best);
                lab.Better.Is((_, best) => double.IsPositiveInfinity(best));
            })
            .Or("the model is replaced by that of each hit, the best t only by a lesser one", lab =>
            {
                lab.Replaces.Is((t, best) => t < best);
                lab.Better.Is((_, _) => true);
            })
            .Or("the best t stays that of the first hit", lab => lab.Replaces.Is((_, best) => double.IsPositiveInfinity(best))),
        new Mistake("far-hit", Affects.Hit, Slides.RayCasting, "the farthest hit shows",
            Farthest,
            "Far things cover near ones.",
            "Which t is the best: the least or the greatest?",
            "Start with the best t = +∞ and keep a hit only if t < best.")
            .Or("the farthest hit shows, of both crossings of a sphere or a box, too", Both + Farthest),
        new Mistake("best0", Affects.Hit, Slides.RayCasting, "the best t starts at 0, so that no hit is nearer",
            lab => lab.Start.Is(() => 0),
            "There is nothing but background.",
            "With which t is the first hit compared?",
            "Start with the best t = +∞.")
            .Or("the best t starts at 1", lab => lab.Start.Is(() => 1))
            .Or("the best t starts at 10", lab => lab.Start.Is(() => 10))
            .Or("the best t starts at |T − P|", lab => lab.Start.Is(() => lab.Length.Do(lab.T - lab.P))),
        new Mistake("znear-t", Affects.Hit, Slides.ClipPlanes, "zNear compared with t where depth is meant (with depth where t is meant)",
            lab => lab.Near.Becomes(near => (t, depth) => near(depth, t)),
            "What the near plane cuts is cut along a wrong line.",
            "What does the scene's \"clip\" say that zNear measures?",
            "For \"depth\": zNear ≤ t · (−d·W); for \"distance\": zNear ≤ t.")
            .Or(OfSome("zNear compared with the other of t and depth",
                (lab, t, depth) => lab.Ahead.Do(t) && lab.Near.Do(depth, t) && lab.Far.Do(t, depth))),
        new Mistake("zfar-t", Affects.Hit, Slides.ClipPlanes, "zFar compared with t where depth is meant (with depth where t is meant)",
            lab => lab.Far.Becomes(far => (t, depth) => far(depth, t)),
            "What the far plane cuts is cut along a wrong line: round for straight, or straight for round.",
            "What does the scene's \"clip\" say that zFar measures?",
            "For \"depth\": t · (−d·W) ≤ zFar; for \"distance\": t ≤ zFar.")
            .Or(OfSome("zFar compared with the other of t and depth",
                (lab, t, depth) => lab.Ahead.Do(t) && lab.Near.Do(t, depth) && lab.Far.Do(depth, t))),
        new Mistake("zboth-t", Affects.Hit, Slides.ClipPlanes, "zNear and zFar compared with t where depth is meant (with depth where t is meant)",
            lab =>
            {
                lab.Near.Becomes(near => (t, depth) => near(depth, t));
                lab.Far.Becomes(far => (t, depth) => far(depth, t));
            },
            "What the near and the far plane cut is cut along wrong lines.",
            "What does the scene's \"clip\" say that zNear and zFar measure?",
            "For \"depth\": zNear ≤ t · (−d·W) ≤ zFar; for \"distance\": zNear ≤ t ≤ zFar.")
            .Or(OfSome("zNear and zFar compared with the other of t and depth",
                (lab, t, depth) => lab.Ahead.Do(t) && lab.Near.Do(depth, t) && lab.Far.Do(depth, t))),
        new Mistake("clip-after", Affects.Hit, Slides.ClipPlanes, "zNear and zFar tested only after the nearest hit was chosen",
            lab => lab.Clipped.Becomes(clipped =>
            {
                lab.Kept.Is(clipped);
                return (t, _) => t <= double.MaxValue;
            }),
            "A near thing that is cut away leaves a hole where what is behind it should show.",
            "A hit before zNear: may it hide another one?",
            "Test whether a crossing counts before it may become the nearest.")
            .Or("zNear tested only after the nearest hit was chosen", lab => lab.Near.Becomes(near =>
            {
                lab.Kept.Is(near);
                return (_, _) => true;
            }))
            .Or("a crossing before zNear or beyond zFar ends the ray with the background", EndsRay((lab, t) => lab.Ahead.Do(t)))
            .Or("a crossing that does not count ends the ray with the background", EndsRay((_, _) => true)),
        new Mistake("no-znear", Affects.Hit, Slides.ClipPlanes, "zNear ignored", lab => lab.Near.Is((_, _) => true),
            "Something close to the camera is in the way.",
            "Which test uses zNear?",
            "A crossing counts only from zNear on.")
            .Or(OfSome("zNear ignored", (lab, t, depth) => lab.Ahead.Do(t) && lab.Far.Do(t, depth))),
        new Mistake("no-zfar", Affects.Hit, Slides.ClipPlanes, "zFar ignored", lab => lab.Far.Is((t, _) => t <= double.MaxValue),
            "There is something where the background should be, far away.",
            "Which test uses zFar?",
            "A crossing counts only up to zFar.")
            .Or(OfSome("zFar ignored", (lab, t, depth) => lab.Ahead.Do(t) && lab.Near.Do(t, depth)))
            .Or(OfSome("zNear and zFar ignored", (lab, t, _) => lab.Ahead.Do(t)))
            .Or("zNear and zFar tested for planes alone", Counted(~Affects.Planes, (lab, t, _) => lab.Ahead.Do(t))),
        new Mistake("bias-big", Affects.Hit, Slides.Bias, "a bias of 1 in place of zNear",
            Bias(1),
            "What is close to the camera is cut at a wrong place.",
            "What is the bias for, and what is zNear for?",
            "t > bias with the scene's tiny bias, and zNear as a test of its own.")
            .Or(OfSome("a bias of 1 in place of zNear", (lab, t, depth) => t > 1 && lab.Far.Do(t, depth))),
        new("clip-root", Affects.Hit, Slides.ClipPlanes,
            "the near crossing of a solid chosen before zNear is tested, so that its far side never shows where it is cut",
            lab => lab.First.Becomes(first => (crossed, d) => first(lab.Ahead.Do(crossed.Near) ? new(crossed.Near) : crossed, d)),
            "A sphere or a box that the near plane cuts has a hole through it.",
            "If the first crossing is cut away, what of the second?",
            "The first crossing that counts is the hit; test both."),
    ];

    private static Action<Lab> Both => lab => lab.OffersBoth = true;

    private static Action<Lab> Bias(double bias) => lab =>
    {
        lab.Ahead.Is(t => t > bias);
        lab.Near.Is((_, _) => true);
    };

    /// <summary>The background for a ray with a first crossing, of those that are tested, that does not count.</summary>
    private static Action<Lab> EndsRay(Func<Lab, double, bool> isTested) => lab =>
    {
        lab.First.Becomes(first => (crossed, d) => double.IsFinite(crossed.Near) && isTested(lab, crossed.Near) && !lab.Counts(crossed.Near, d)
            ? double.NegativeInfinity // no hit is nearer
            : first(crossed, d));
        lab.Kept.Is((t, _) => t > double.NegativeInfinity);
    };

    private static Action<Lab> Farthest => lab =>
    {
        lab.Start.Is(() => double.NegativeInfinity);
        lab.Better.Is((t, best) => t > best);
    };

    /// <summary>A mistake with each hit, where the first crossing of a body that counts is its hit, and where both crossings are.</summary>
    private static (string, Action<Lab>)[] Either(string what, Action<Lab> deviate) =>
        [(what, deviate), (what + "; both crossings of a sphere or a box are hits", Both + deviate)];

    /// <summary>Another test for one kind of shape, for the two that have an inside, and for the flat ones.</summary>
    private static IEnumerable<(string, Action<Lab>)> OfSome(string what, Func<Lab, double, double, bool> counts) =>
        from some in (IEnumerable<(string Many, Affects Shapes)>)
        [
            .. ShapeKind.Basic.Select(kind => (kind.Many, kind.Formula)),
            ("spheres and boxes", Affects.Spheres | Affects.Boxes),
            ("planes, circles and triangles", Affects.Planes | Affects.Circles | Affects.Triangles),
        ]
        select ($"{what} for {some.Many}", Counted(some.Shapes, counts));

    /// <summary>Another test, by t and depth, of whether a crossing of such shapes counts.</summary>
    private static Action<Lab> Counted(Affects shapes, Func<Lab, double, double, bool> counts) => lab => lab.Hit.Becomes(hit => (model, d) =>
    {
        if ((Mistake.KindOf(model) & shapes) == 0 || lab.CrossingsOf(model, d) is not { } crossed) return hit(model, d);
        return Counts(crossed.Near) ? crossed.Near : Counts(crossed.Far) ? crossed.Far : null;

        bool Counts(double t) => t <= double.MaxValue && counts(lab, t, lab.Depth.Do(t, d));
    });
}
