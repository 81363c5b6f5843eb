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
            .Or("the camera stands at T and looks at P", lab => lab.SwapEnds()),
        new("dir-plus-w", Affects.Camera, Slides.PixelTranslation, "d = uc U + ur V + W",
            lab => lab.Towards.Becomes(towards => (uc, ur) => -towards(-uc, -ur)),
            "Nothing in front of the camera is visible.",
            "W points backwards. With which sign does it go into d?",
            "d = (uc U + ur V − W) normalised."),
        new Mistake("dir-plus-p", Affects.Camera, Slides.PixelTranslation,
            "d = P + uc U + ur V − W: a point of the plane taken for the direction to it",
            lab => lab.Towards.Becomes(towards => (uc, ur) => lab.P + towards(uc, ur)),
            "The camera looks away from the world's origin, or all is far too small; moving it turns it.",
            "P + uc U + ur V − W is a point. Which vector leads to it from P?",
            "d = (uc U + ur V − W) normalised: that point less P.")
            .Or("d = uc U + ur V − W − P", lab => lab.Towards.Becomes(towards => (uc, ur) => towards(uc, ur) - lab.P)),
        new("u-cross", Affects.Camera, Slides.Camera, "U = W × up; V = W × U turns with it",
            lab => lab.AxisU.Becomes(U => (up, w) => -U(up, w)),
            "The picture is turned by 180 degrees.",
            "a × b = −(b × a). In which order does the slide have up and W?",
            "U = (up × W) normalised."),
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
        new("t-dir", Affects.Camera, Slides.Camera, "W = −T normalised: the target taken for a direction",
            lab => lab.ToTarget.Is((_, t) => t),
            "The camera looks somewhere else; moving it does not turn it.",
            "The target is a point. Which vector leads from P to it?",
            "W = −(T − P) normalised."),
        new("v-up", Affects.Camera, Slides.Camera, "V = up, which is not perpendicular to W",
            lab => lab.AxisV.Is((w, u) => lab.Unit.Do(lab.Camera.Up)),
            "A tilted camera shows everything stretched upwards, and shifted.",
            "Which angle do V and W have where the camera looks down?",
            "V = W × U."),
        new("uv-swap", Affects.Camera, Slides.PixelTranslation, "U and V swapped: d = uc V + ur U − W",
            lab => lab.Towards.Becomes(towards => (uc, ur) => towards(ur, uc)),
            "The picture is mirrored at its rising diagonal; in a wide picture it is stretched, too.",
            "Columns count to the right. Which of uc and ur do they give, and which of U and V points to the right?",
            "d = (uc U + ur V − W) normalised."),
    ];
}
