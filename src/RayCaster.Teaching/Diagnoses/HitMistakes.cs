namespace RayCaster.Teaching;

/// <summary>Which crossing counts, and which hit shows.</summary>
internal static class HitMistakes
{
    public static Mistake[] All =>
    [
        new("no-t0", Concerns.Hit, Slides.NearestHit, "no least t at all: what lies behind the camera shows",
            lab =>
            {
                lab.Ahead.Becomes(_ => t => t > double.NegativeInfinity);
                lab.Near.Becomes(_ => (_, _) => true);
            })
        {
            Hint = new("Things from behind the camera are in the picture, upside down and glaring.",
                "Where on the ray is a point with t = −3?",
                "A crossing counts only if t > bias, and from zNear on."),
        },
        new("last-hit", Concerns.Hit, Slides.NearestHit, "the last model hit shows, not the nearest",
            lab => lab.Better.Becomes(_ => (_, _) => true))
        {
            Hint = new("Far things cover near ones; the order of the models changes the picture.",
                "When may a hit replace the one that was found before?",
                "Keep a hit only if its t is less than the best t so far."),
        },
        new("far-hit", Concerns.Hit, Slides.NearestHit, "the farthest hit shows",
            lab =>
            {
                lab.Start.Becomes(_ => () => double.NegativeInfinity);
                lab.Better.Becomes(_ => (t, best) => t > best);
            })
        {
            Hint = new("Far things cover near ones.",
                "Which t is the best: the least or the greatest?",
                "Start with the best t = +∞ and keep a hit only if t < best."),
        },
        new("best0", Concerns.Hit, Slides.NearestHit, "the best t starts at 0, so that no hit is nearer",
            lab => lab.Start.Becomes(_ => () => 0))
        {
            Hint = new("There is nothing but background.",
                "With which t is the first hit compared?",
                "Start with the best t = +∞."),
        },
        new("znear-t", Concerns.Hit, Slides.ClipPlanes, "zNear compared with t where depth is meant (with depth where t is meant)",
            lab => lab.Near.Becomes(near => (t, depth) => near(depth, t)))
        {
            Hint = new("What the near plane cuts is cut along a wrong line.",
                "What does the scene's \"clip\" say that zNear measures?",
                "For \"depth\": zNear ≤ t · (−d·W); for \"distance\": zNear ≤ t."),
        },
        new("zfar-t", Concerns.Hit, Slides.ClipPlanes, "zFar compared with t where depth is meant (with depth where t is meant)",
            lab => lab.Far.Becomes(far => (t, depth) => far(depth, t)))
        {
            Hint = new("What the far plane cuts is cut along a wrong line: round for straight, or straight for round.",
                "What does the scene's \"clip\" say that zFar measures?",
                "For \"depth\": t · (−d·W) ≤ zFar; for \"distance\": t ≤ zFar."),
        },
        new("zboth-t", Concerns.Hit, Slides.ClipPlanes, "zNear and zFar compared with t where depth is meant (with depth where t is meant)",
            lab =>
            {
                lab.Near.Becomes(near => (t, depth) => near(depth, t));
                lab.Far.Becomes(far => (t, depth) => far(depth, t));
            })
        {
            Hint = new("What the near and the far plane cut is cut along wrong lines.",
                "What does the scene's \"clip\" say that zNear and zFar measure?",
                "For \"depth\": zNear ≤ t · (−d·W) ≤ zFar; for \"distance\": zNear ≤ t ≤ zFar."),
        },
        new("clip-after", Concerns.Hit, Slides.ClipPlanes, "zNear and zFar asked only after the nearest hit was chosen",
            lab => lab.Clipped.Becomes(clipped =>
            {
                lab.Kept.Becomes(_ => clipped);
                return (t, _) => t <= double.MaxValue;
            }))
        {
            Hint = new("A near thing that is cut away leaves a hole where what is behind it should show.",
                "A hit before zNear: may it hide another one?",
                "Ask each crossing whether it counts before it may become the nearest."),
        },
        new("no-znear", Concerns.Hit, Slides.ClipPlanes, "zNear ignored", lab => lab.Near.Becomes(_ => (_, _) => true))
        {
            Hint = new("Something close to the camera is in the way.",
                "Which test uses zNear?",
                "A crossing counts only from zNear on."),
        },
        new("no-zfar", Concerns.Hit, Slides.ClipPlanes, "zFar ignored", lab => lab.Far.Becomes(_ => (t, _) => t <= double.MaxValue))
        {
            Hint = new("There is something where the background should be, far away.",
                "Which test uses zFar?",
                "A crossing counts only up to zFar."),
        },
        new("bias-big", Concerns.Hit, Slides.ClipPlanes, "a bias of 1 in place of zNear",
            lab =>
            {
                lab.Ahead.Becomes(_ => t => t > 1);
                lab.Near.Becomes(_ => (_, _) => true);
            })
        {
            Hint = new("What is close to the camera is cut at a wrong place.",
                "What is the bias for, and what is zNear for?",
                "t > bias with the scene's tiny bias, and zNear as a test of its own."),
        },
        new("clip-root", Concerns.Hit, Slides.ClipPlanes,
            "the near crossing of a body chosen before zNear is asked, so that its far side never shows where it is cut",
            lab => lab.First.Becomes(first => (crossed, d) => first(lab.Ahead.Do(crossed.Near) ? new(crossed.Near) : crossed, d)))
        {
            Hint = new("A sphere or a box that the near plane cuts has a hole through it.",
                "If the first crossing is cut away, what of the second?",
                "The first crossing that counts is the hit; ask both."),
        },
    ];
}
