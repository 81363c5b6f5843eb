namespace RayCaster.Teaching;

/// <summary>In the camera's axes W, U and V.</summary>
internal static class AxisMistakes
{
    public static Mistake[] All =>
    [
        new Mistake("w-sign", Affects.Camera, Slides.Camera, "W = +(T − P) normalised, so that the camera looks backwards",
            lab => lab.AxisW.Becomes(W => toTarget => -W(toTarget)),
            "The picture shows what is behind the camera, or nothing.",
            "Which way does W point: to the target, or away from it?",
            "W = −(T − P) normalised: it points backwards, and d has −W in it.")
            .Or("W = +(T − P) normalised, while the depth is measured along −W",
                lab => lab.Towards.Becomes(towards => (uc, ur) => -towards(uc, -ur)))
            .Or("the camera stands at T and looks at P", lab => lab.SwapEnds()),
        new Mistake("dir-plus-w", Affects.Camera, Slides.PixelTranslation, "d = uc U + ur V + W",
            lab => lab.Towards.Becomes(towards => (uc, ur) => -towards(-uc, -ur)),
            "Nothing in front of the camera is visible.",
            "W points backwards. With which sign does it go into d?",
            "d = (uc U + ur V − W) normalised.")
            .Or("d = −(uc U + ur V − W)", lab => lab.Towards.Becomes(towards => (uc, ur) => -towards(uc, ur)))
            .Or("d = uc U + ur V + W, and the depth is measured along +W, too", lab =>
            {
                lab.AxisW.Becomes(W => toTarget => -W(toTarget)); // turns U about, but not V
                lab.Towards.Becomes(towards => (uc, ur) => towards(-uc, ur));
            }),
        new Mistake("u-cross", Affects.Camera, Slides.Camera, "U = W × up; V = W × U turns with it",
            lab => lab.AxisU.Becomes(U => (up, w) => -U(up, w)),
            "The picture is turned by 180 degrees.",
            "a × b = −(b × a). In which order does the slide have up and W?",
            "U = (up × W) normalised.")
            .Or("lines and columns both written from the other end", lab => lab.Shown.Becomes(shown => (x, y) =>
                shown(lab.Camera.Width - 1 - x, lab.Camera.Height - 1 - y))),
        new("v-cross", Affects.Camera, Slides.Camera, "V = U × W, so that V points down",
            lab => lab.AxisV.Becomes(V => (w, u) => -V(w, u)),
            "The picture is upside down, and a row off.",
            "Does V point up? Try W and U of a level camera by hand.",
            "V = W × U."),
        new("u-only", Affects.Camera, Slides.Camera, "U points to the left while V is right",
            lab => lab.Towards.Becomes(towards => (uc, ur) => towards(-uc, ur)),
            "The picture is mirrored left to right, and a column off.",
            "Look along −W, with V upwards: on which side is U?",
            "U = (up × W) normalised, V = W × U, and uc is multiplied by U as it is."),
        new Mistake("t-dir", Affects.Camera, Slides.Camera, "W = −T normalised: the target taken for a direction",
            lab => lab.ToTarget.Is((_, t) => t),
            "The camera looks somewhere else; moving it does not turn it.",
            "The target is a point. Which vector leads from P to it?",
            "W = −(T − P) normalised.")
            .Or("W = P normalised: the camera looks at the origin", lab => lab.ToTarget.Is((p, _) => -p))
            .Or("W = −(T + P) normalised", lab => lab.ToTarget.Is((p, t) => t + p))
            .Or("W = −T normalised, while d leads to a plane through T", ThroughTarget + (lab => lab.ToTarget.Is((_, t) => t)))
            .Or("W = P normalised, while d leads to a plane through T", ThroughTarget + (lab => lab.ToTarget.Is((p, _) => -p)))
            .Or(AcrossUp("T", lab => lab.T))
            .Or(AcrossUp("P", lab => lab.P))
            .Or("d = uc U + ur V + T", Add(lab => lab.W + lab.T))
            .Or("d = P + uc U + ur V − W: the point of the plane taken for a direction", Add(lab => lab.P))
            .Or("d = uc U + ur V − W − P", Add(lab => -lab.P)),
        new Mistake("v-up", Affects.Camera, Slides.Camera, "V = up, which is not perpendicular to W",
            lab => lab.AxisV.Is((w, u) => lab.Unit.Do(lab.Camera.Up)),
            "A tilted camera shows everything stretched upwards, and shifted.",
            "Which angle do V and W have where the camera looks down?",
            "V = W × U.")
            .In(CameraWays.ByInverse)
            .Or("V = −up", lab => lab.AxisV.Is((w, u) => -lab.Unit.Do(lab.Camera.Up)))
            .Or("V = up, not normalised", lab => lab.AxisV.Is((w, u) => lab.Camera.Up))
            .Or("V = (0, 0, 1)", lab => lab.AxisV.Is((w, u) => new(0, 0, 1)))
            .Or("V = up × U", lab => lab.AxisV.Is((w, u) => lab.Cross.Do(lab.Camera.Up, u)))
            .Or("V = U × up", lab => lab.AxisV.Is((w, u) => lab.Cross.Do(u, lab.Camera.Up)))
            .Or("V = W × up", lab => lab.AxisV.Is((w, _) => lab.Cross.Do(w, lab.Camera.Up)))
            .Or("V = up × W", lab => lab.AxisV.Is((w, _) => lab.Cross.Do(lab.Camera.Up, w))),
        new Mistake("uv-swap", Affects.Camera, Slides.PixelTranslation, "U and V swapped: d = uc V + ur U − W",
            lab => lab.Towards.Becomes(towards => (uc, ur) => towards(ur, uc)),
            "The picture is mirrored at its rising diagonal; in a wide picture it is stretched, too.",
            "Columns count to the right. Which of uc and ur do they give, and which of U and V points to the right?",
            "d = (uc U + ur V − W) normalised.")
            .Or("uc = w r / height − w / 2, ur = h c / width − h / 2",
                lab => lab.Sample.Becomes(sample => (c, r) => sample(c, r) is var (x, y) ? (y * lab.Wide, x * lab.Tall) : default))
            .Or("uc = w r / width − w / 2", lab => lab.Sample.Becomes(sample => (_, r) => sample(r, r)))
            .Or("ur = h c / height − h / 2", lab => lab.Sample.Becomes(sample => (c, _) => sample(c, c)))
            .Or(from d in ((string Is, Func<double, double, (double U, double V)> Of)[])
                [
                    ("uc U + uc V", (uc, _) => (uc, uc)), ("ur U + ur V", (_, ur) => (ur, ur)), ("uc U + ur U", (uc, ur) => (uc + ur, 0)),
                    ("uc V + ur V", (uc, ur) => (0, uc + ur)), ("ur V", (_, ur) => (0, ur)), ("uc U", (uc, _) => (uc, 0)),
                    ("ur U − uc V", (uc, ur) => (ur, -uc)), ("−ur U + uc V", (uc, ur) => (-ur, uc)), ("−ur U − uc V", (uc, ur) => (-ur, -uc)),
                ]
                select ($"d = {d.Is} − W", (Action<Lab>)(lab => lab.Towards.Becomes(towards => (uc, ur) =>
                    d.Of(uc, ur) is var (ofU, ofV) ? towards(ofU, ofV) : default)))),
    ];

    /// <summary>Another vector in the place of W where U is computed, in either order.</summary>
    private static (string, Action<Lab>)[] AcrossUp(string name, Func<Lab, Vector3> vector) =>
    [
        ($"U = (up × {name}) normalised", lab => lab.AxisU.Is((up, w) => lab.Unit.Do(lab.Cross.Do(up, vector(lab))))),
        ($"U = ({name} × up) normalised", lab => lab.AxisU.Is((up, w) => lab.Unit.Do(lab.Cross.Do(vector(lab), up)))),
    ];

    /// <summary>d and the depth take (T − P) / |T − P| where they should take −W.</summary>
    private static Action<Lab> ThroughTarget => VectorMistakes.RightDepth
        + (lab => lab.Towards.Is((uc, ur) => uc * lab.U + ur * lab.V + (lab.T - lab.P).Normalized));

    /// <summary>Adds a vector to d before d is normalised.</summary>
    private static Action<Lab> Add(Func<Lab, Vector3> vector) => lab => lab.Towards.Becomes(towards => (uc, ur) => towards(uc, ur) + vector(lab));
}
