namespace RayCaster.Teaching;

/// <summary>In h and w, the height and the width of the picture's plane.</summary>
internal static class ImagePlaneMistakes
{
    public static Mistake[] All =>
    [
        new("rad", Affects.Camera, Slides.Camera, "degrees into Math.Tan, which takes radians",
            lab => lab.PlaneHeight.Becomes(h => fovY => h(fovY * 180 / Math.PI)),
            "Everything has a wrong size, and may be turned by 180 degrees.",
            "In which unit is fovY, and in which unit does Math.Tan take its angle?",
            "h = 2 · Math.Tan(fovY · Math.PI / 180 / 2)."),
        new("nohalf", Affects.Camera, Slides.Camera, "h = 2 tan(fovY): the half of the angle is missing",
            lab => lab.PlaneHeight.Becomes(h => fovY => h(2 * fovY)),
            "Everything is too small: the angle of view is too wide.",
            "The right-angled triangle from the camera to the upper edge: which part of fovY is its angle?",
            "h = 2 tan(fovY / 2)."),
        new("no2", Affects.Camera, Slides.Camera, "h = tan(fovY / 2): half of the plane's height",
            lab => lab.PlaneHeight.Becomes(h => fovY => h(fovY) / 2),
            "Everything is twice as large as it should be.",
            "tan(fovY / 2) reaches from the axis to the upper edge. How far is it from edge to edge?",
            "h = 2 tan(fovY / 2)."),
        new Mistake("no-tan", Affects.Camera, Slides.Camera, "the tangent is forgotten: h = 2 · fovY / 2",
            lab => lab.PlaneHeight.Is(fovY => fovY * Math.PI / 180),
            "Everything is somewhat too large; the wider the view, the more.",
            "A right-angled triangle with an angle and the side 1 beside it: how long is the side opposite to it?",
            "h = 2 tan(fovY / 2).")
            .Or("the arc tangent for the tangent", lab => lab.PlaneHeight.Is(fovY => 2 * Math.Atan(fovY * Math.PI / 360))),
        new("aspect-inv", Affects.Camera, Slides.Camera, "w = h · height / width",
            lab => lab.PlaneWidth.Is(h => h * lab.Camera.Height / lab.Camera.Width),
            "All is far too long along the picture's longer side, as if stretched.",
            "Wide pictures need a wide plane. Which is larger in yours, w or h?",
            "w = h · width / height."),
        new("aspect-none", Affects.Camera, Slides.Camera, "w = h, whatever the picture's shape",
            lab => lab.PlaneWidth.Is(h => h),
            "All is too long along the picture's longer side, as if stretched.",
            "Is a pixel of the plane a square?",
            "w = h · width / height."),
        new("aspect-int", Affects.Camera, Slides.Camera, "w = h · (width / height), divided in integers",
            lab => lab.PlaneWidth.Is(h => h * (lab.Camera.Width / lab.Camera.Height)),
            "All is stretched; a picture that is higher than wide has only stripes.",
            "What is 320 / 200 in C#, where both are int?",
            "w = h · width / height, from left to right: h is a double, so no integers are divided."),
        new("fov-horiz", Affects.Camera, Slides.Camera, "fovY taken from the left edge to the right one",
            lab => lab.PlaneHeight.Becomes(h => fovY => h(fovY) * lab.Tall),
            "The whole picture is zoomed, with the right proportions.",
            "The Y in fovY: which two edges are that angle apart?",
            "h = 2 tan(fovY / 2) is the height; the width follows, w = h · width / height."),
    ];
}
