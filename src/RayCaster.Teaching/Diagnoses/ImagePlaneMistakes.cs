namespace RayCaster.Teaching;

/// <summary>In h and w, the height and the width of the picture's plane.</summary>
internal static class ImagePlaneMistakes
{
    public static Mistake[] All =>
    [
        new Mistake("rad", Affects.Camera, Slides.Camera, "degrees into Math.Tan, which takes radians",
            lab => lab.PlaneHeight.Becomes(h => fovY => h(fovY * 180 / Math.PI)),
            "Everything has a wrong size, and may be turned by 180 degrees.",
            "In which unit is fovY, and in which unit does Math.Tan take its angle?",
            "h = 2 · Math.Tan(fovY · Math.PI / 180 / 2).")
            .Or("degrees, in −W / tan(fovY / 2)", VectorMistakes.Zoom + (lab => lab.PlaneHeight.Becomes(h => fovY => h(fovY * 180 / Math.PI))))
            .Or("fovY · 180 / π, in −W / tan(fovY / 2)",
                VectorMistakes.Zoom + (lab => lab.PlaneHeight.Becomes(h => fovY => h(fovY * (180 / Math.PI) * (180 / Math.PI)))))
            .Or("degrees, and the half is missing, too: 2 tan(fovY)", lab => lab.PlaneHeight.Becomes(h => fovY => h(2 * fovY * 180 / Math.PI)))
            .Or("degrees, and tan(fovY)", lab => lab.PlaneHeight.Becomes(h => fovY => h(2 * fovY * 180 / Math.PI) / 2))
            .Or("fovY · 180 / π", lab => lab.PlaneHeight.Becomes(h => fovY => h(fovY * (180 / Math.PI) * (180 / Math.PI))))
            .Or("fovY · π, without / 180", lab => lab.PlaneHeight.Becomes(h => fovY => h(fovY * 180)))
            .Or("fovY / 180, without π", lab => lab.PlaneHeight.Becomes(h => fovY => h(fovY / Math.PI)))
            .Or("fovY · 3 / 180: π cut to an integer", lab => lab.PlaneHeight.Becomes(h => fovY => h(fovY * 3 / Math.PI)))
            .Or("2 tan(fovY / 2) · π / 180", lab => lab.PlaneHeight.Becomes(h => fovY => h(fovY * 180 / Math.PI) * Math.PI / 180))
            .Or("2 tan(fovY / 2) · 180 / π", lab => lab.PlaneHeight.Becomes(h => fovY => h(fovY * 180 / Math.PI) * 180 / Math.PI))
            .Or(OneSide("degrees in the tangent", a => Math.Tan(a * 180 / Math.PI))),
        new Mistake("nohalf", Affects.Camera, Slides.Camera, "h = 2 tan(fovY): the half of the angle is missing",
            lab => lab.PlaneHeight.Becomes(h => fovY => h(2 * fovY)),
            "Everything is too small: the angle of view is too wide.",
            "The right-angled triangle from the camera to the upper edge: which part of fovY is its angle?",
            "h = 2 tan(fovY / 2).")
            .Or("h = tan(fovY)", lab => lab.PlaneHeight.Becomes(h => fovY => h(2 * fovY) / 2))
            .Or("h = tan(fovY) / 2", lab => lab.PlaneHeight.Becomes(h => fovY => h(2 * fovY) / 4))
            .Or("h = 2 tan(fovY / 4): the angle is halved twice", lab => lab.PlaneHeight.Becomes(h => fovY => h(fovY / 2)))
            .Or(OneSide("tan(fovY)", a => Math.Tan(2 * a))),
        new Mistake("no2", Affects.Camera, Slides.Camera, "h = tan(fovY / 2): half of the plane's height",
            lab => lab.PlaneHeight.Becomes(h => fovY => h(fovY) / 2),
            "Everything is twice as large as it should be.",
            "tan(fovY / 2) reaches from the axis to the upper edge. How far is it from edge to edge?",
            "h = 2 tan(fovY / 2).")
            .Or("h = 4 tan(fovY / 2)", lab => lab.PlaneHeight.Becomes(h => fovY => h(fovY) * 2))
            .Or(OneSide("tan(fovY / 2) without the 2", a => Math.Tan(a) / 2))
            .Or(OneSide("4 tan(fovY / 2)", a => 2 * Math.Tan(a)))
            .Or("h = tan(fovY / 2) / 2", lab => lab.PlaneHeight.Becomes(h => fovY => h(fovY) / 4)),
        new Mistake("no-tan", Affects.Camera, Slides.Camera, "the tangent is forgotten: h = 2 · fovY / 2",
            lab => lab.Tan.Is(a => a),
            "Everything is somewhat too large; the wider the view, the more.",
            "A right-angled triangle with an angle and the side 1 beside it: how long is the side opposite to it?",
            "h = 2 tan(fovY / 2).")
            .Or("the sine for the tangent", lab => lab.Tan.Is(Math.Sin))
            .Or("the cosine for the tangent", lab => lab.Tan.Is(Math.Cos))
            .Or("the arc tangent for the tangent", lab => lab.Tan.Is(Math.Atan))
            .Or("1 / tan", lab => lab.Tan.Is(a => 1 / Math.Tan(a)))
            .Or("h = 2 · fovY", lab => lab.Tan.Is(a => 2 * a))
            .Or("h = 2, whatever fovY is", lab => lab.Tan.Is(_ => 1))
            .Or("h = 1, whatever fovY is", lab => lab.Tan.Is(_ => 0.5))
            .Or("h = 2 and w = 2: uc and ur run from −1 to 1", Square(2))
            .Or("h = 1 and w = 1: uc and ur run from −1/2 to 1/2", Square(1))
            .Or("w = width / height, without h", lab => lab.PlaneWidth.Is(_ => lab.Wide))
            .Or("w = 2 · width / height, without h", lab => lab.PlaneWidth.Is(_ => 2 * lab.Wide))
            .Or("1 / (2 tan)", lab => lab.Tan.Is(a => 0.5 / Math.Tan(a)))
            .Or("sin · cos for the tangent", lab => lab.Tan.Is(a => Math.Sin(a) * Math.Cos(a)))
            .Or(OneSide("fovY / 2, in radians", a => a))
            .Or(OneSide("2, whatever fovY is", _ => 1)),
        new Mistake("aspect-inv", Affects.Camera, Slides.Camera, "w = h · height / width",
            lab => lab.PlaneWidth.Is(h => h * lab.Camera.Height / lab.Camera.Width),
            "All is far too long along the picture's longer side, as if stretched.",
            "Wide pictures need a wide plane. Which is larger in yours, w or h?",
            "w = h · width / height.")
            .Or("w = 2 tan(fovY / 2), h = w · width / height", lab => Stretch(lab, lab.Tall, lab.Wide))
            .Or("w = h · (width / height)²", lab => Stretch(lab, lab.Wide, 1)),
        new Mistake("aspect-none", Affects.Camera, Slides.Camera, "w = h, whatever the picture's shape",
            lab => lab.PlaneWidth.Is(h => h),
            "All is too long along the picture's longer side, as if stretched.",
            "Is a pixel of the plane a square?",
            "w = h · width / height.")
            .Or("h = w", lab => Stretch(lab, 1, lab.Wide)),
        new Mistake("aspect-int", Affects.Camera, Slides.Camera, "w = h · (width / height), divided in integers",
            lab => lab.PlaneWidth.Is(h => h * (lab.Camera.Width / lab.Camera.Height)),
            "All is stretched; a picture that is higher than wide has only stripes.",
            "What is 320 / 200 in C#, where both are int?",
            "w = h · width / height, from left to right: h is a double, so no integers are divided.")
            .Or("w = h · (height / width), divided in integers", lab => lab.PlaneWidth.Is(h => h * (lab.Camera.Height / lab.Camera.Width))),
        new Mistake("fov-horiz", Affects.Camera, Slides.Camera, "fovY taken from the left edge to the right one",
            lab => lab.PlaneHeight.Becomes(h => fovY => h(fovY) * lab.Tall),
            "The whole picture is zoomed, with the right proportions.",
            "The Y in fovY: which two edges are that angle apart?",
            "h = 2 tan(fovY / 2) is the height; the width follows, w = h · width / height.")
            .Or("h = 2 tan(fovY / 2) · width / height", lab => lab.PlaneHeight.Becomes(h => fovY => h(fovY) * lab.Wide))
            .Or("w = 2 tan(fovY · width / height / 2)",
                lab => lab.PlaneWidth.Is(_ => 2 * lab.Tan.Do(lab.Camera.FovY * lab.Wide * Math.PI / 180 / 2)))
            .Or("h = 2 tan(fovY · height / width / 2)", lab => lab.PlaneHeight.Becomes(h => fovY => h(fovY * lab.Tall))),
    ];

    /// <summary>h and w are so much, whatever fovY and the picture's sides are.</summary>
    private static Action<Lab> Square(double side) => lab =>
    {
        lab.PlaneHeight.Is(_ => side);
        lab.PlaneWidth.Is(_ => side);
    };

    /// <summary>Another formula for h alone, and for w alone.</summary>
    /// <param name="what">The formula in words.</param>
    /// <param name="tangent">Half of fovY, in radians → what stands for its tangent.</param>
    private static IEnumerable<(string, Action<Lab>)> OneSide(string what, Func<double, double> tangent)
    {
        yield return ($"h alone: {what}", lab => Stretch(lab, 1, Times(lab.Camera.FovY * Math.PI / 360)));
        yield return ($"w alone: {what}", lab => Stretch(lab, Times(lab.Camera.FovY * Math.PI / 360), 1));

        double Times(double half) => tangent(half) / Math.Tan(half);
    }

    /// <summary>w and h, each so many times what they are.</summary>
    private static void Stretch(Lab lab, double w, double h)
    {
        lab.PlaneHeight.Becomes(height => fovY => h * height(fovY));
        lab.PlaneWidth.Becomes(width => height => w / h * width(height));
    }
}
