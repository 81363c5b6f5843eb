namespace RayCaster.Teaching;

/// <summary>Between a pixel and its place in the plane of the picture.</summary>
internal static class PixelMistakes
{
    public static Mistake[] All => [.. OfPlane, .. OfPixels];

    private static Mistake[] OfPlane =>
    [
        new Mistake("rad", Concerns.Camera, Slides.Camera, "degrees into Math.Tan, which takes radians",
            lab => lab.PlaneHeight.Becomes(h => fovY => h(fovY * 180 / Math.PI)),
            "Everything has a wrong size, and may be turned by 180 degrees.",
            "In which unit is fovY, and in which unit does Math.Tan take its angle?",
            "h = 2 · Math.Tan(fovY · Math.PI / 180 / 2).")
            .Or("fovY · 180 / π", lab => lab.PlaneHeight.Becomes(h => fovY => h(fovY * (180 / Math.PI) * (180 / Math.PI))))
            .Or("fovY · π, without / 180", lab => lab.PlaneHeight.Becomes(h => fovY => h(fovY * 180)))
            .Or("fovY / 180, without π", lab => lab.PlaneHeight.Becomes(h => fovY => h(fovY / Math.PI))),
        new Mistake("nohalf", Concerns.Camera, Slides.Camera, "h = 2 tan(fovY): the half of the angle is missing",
            lab => lab.PlaneHeight.Becomes(h => fovY => h(2 * fovY)),
            "Everything is too small: the angle of view is too wide.",
            "The right-angled triangle from the camera to the upper edge: which part of fovY is its angle?",
            "h = 2 tan(fovY / 2).")
            .Or("h = tan(fovY)", lab => lab.PlaneHeight.Becomes(h => fovY => h(2 * fovY) / 2)),
        new Mistake("no2", Concerns.Camera, Slides.Camera, "h = tan(fovY / 2): half of the plane's height",
            lab => lab.PlaneHeight.Becomes(h => fovY => h(fovY) / 2),
            "Everything is twice as large as it should be.",
            "tan(fovY / 2) reaches from the axis to the upper edge. How far is it from edge to edge?",
            "h = 2 tan(fovY / 2).")
            .Or("h = 4 tan(fovY / 2)", lab => lab.PlaneHeight.Becomes(h => fovY => h(fovY) * 2))
            .Or("h = tan(fovY / 2), while w is right", lab => Stretch(lab, 1, 0.5))
            .Or("w = tan(fovY / 2) · width / height, while h is right", lab => Stretch(lab, 0.5, 1))
            .Or("h = tan(fovY) / 2", lab => lab.PlaneHeight.Becomes(h => fovY => h(2 * fovY) / 4)),
        new Mistake("no-tan", Concerns.Camera, Slides.Camera, "the tangent is forgotten: h = 2 · fovY / 2",
            lab => lab.Tan.Is(a => a),
            "Everything is somewhat too large; the wider the view, the more.",
            "A right-angled triangle with an angle and the side 1 beside it: how long is the side opposite to it?",
            "h = 2 tan(fovY / 2).")
            .Or("the sine for the tangent", lab => lab.Tan.Is(Math.Sin))
            .Or("the cosine for the tangent", lab => lab.Tan.Is(Math.Cos))
            .Or("the arc tangent for the tangent", lab => lab.Tan.Is(Math.Atan))
            .Or("1 / tan", lab => lab.Tan.Is(a => 1 / Math.Tan(a)))
            .Or("h = 2 · fovY", lab => lab.Tan.Is(a => 2 * a)),
        new Mistake("aspect-inv", Concerns.Camera, Slides.Camera, "w = h · height / width",
            lab => lab.PlaneWidth.Is(h => h * lab.Camera.Height / lab.Camera.Width),
            "Spheres are ellipses, far too long along the picture's longer side.",
            "Wide pictures need a wide plane. Which is larger in yours, w or h?",
            "w = h · width / height.")
            .Or("w = 2 tan(fovY / 2), h = w · width / height", lab => Stretch(lab, lab.Tall, lab.Wide)),
        new Mistake("aspect-none", Concerns.Camera, Slides.Camera, "w = h, whatever the picture's shape",
            lab => lab.PlaneWidth.Is(h => h),
            "Spheres are ellipses, too long along the picture's longer side.",
            "Is a pixel of the plane a square?",
            "w = h · width / height.")
            .Or("h = w", lab => Stretch(lab, 1, lab.Wide)),
        new Mistake("aspect-int", Concerns.Camera, Slides.Camera, "w = h · (width / height), divided in integers",
            lab => lab.PlaneWidth.Is(h => h * (lab.Camera.Width / lab.Camera.Height)),
            "Spheres are ellipses; a picture that is higher than wide has only stripes.",
            "What is 320 / 200 in C#, where both are int?",
            "w = h · width / height, from left to right: h is a double, so no integers are divided.")
            .Or("w = h · (height / width), divided in integers", lab => lab.PlaneWidth.Is(h => h * (lab.Camera.Height / lab.Camera.Width))),
        new Mistake("fov-horiz", Concerns.Camera, Slides.Camera, "fovY taken from the left edge to the right one",
            lab => lab.PlaneHeight.Becomes(h => fovY => h(fovY) * lab.Tall),
            "The whole picture is zoomed, with the right proportions.",
            "The Y in fovY: which two edges are that angle apart?",
            "h = 2 tan(fovY / 2) is the height; the width follows, w = h · width / height.")
            .Or("h = 2 tan(fovY / 2) · width / height", lab => lab.PlaneHeight.Becomes(h => fovY => h(fovY) * lab.Wide)),
    ];

    private static Mistake[] OfPixels =>
    [
        new Mistake("pix-int", Concerns.Camera, Slides.PixelTranslation, "w · (c / width), divided in integers: always 0",
            lab =>
            {
                lab.Uc.Becomes(uc => c => uc(lab.Camera.Width * Math.Floor(c / lab.Camera.Width)));
                lab.Ur.Becomes(ur => r => ur(lab.Camera.Height * Math.Floor(r / lab.Camera.Height)));
            },
            "The picture has one colour, or stripes: all rays of it, of a line or of a column are the same.",
            "What is c / width in C#, where both are int?",
            "uc = w · c / width − w / 2, from left to right: w is a double, so no integers are divided.")
            .Or("only c / width is divided in integers", lab => lab.Uc.Becomes(uc => c => uc(lab.Camera.Width * Math.Floor(c / lab.Camera.Width))))
            .Or("only r / height is divided in integers",
                lab => lab.Ur.Becomes(ur => r => ur(lab.Camera.Height * Math.Floor(r / lab.Camera.Height)))),
        new Mistake("no-center", Concerns.Camera, Slides.PixelTranslation, "uc and ur without − w / 2 and − h / 2",
            lab => Shift(lab, 0, 0),
            "What should be in the middle is at a corner or at an edge.",
            "Which pixel has uc = 0 and ur = 0?",
            "uc = w c / width − w / 2, ur = h r / height − h / 2.")
            .Or("uc without − w / 2", lab => Shift(lab, 0, 0.5))
            .Or("ur without − h / 2", lab => Shift(lab, 0.5, 0))
            .Or("− w and − h where their halves are meant", lab => Shift(lab, 1, 1))
            .Or("+ w / 2 and + h / 2", lab => Shift(lab, -0.5, -0.5))
            .Or("+ w / 2 for − w / 2", lab => Shift(lab, -0.5, 0.5))
            .Or("+ h / 2 for − h / 2", lab => Shift(lab, 0.5, -0.5))
            .Or("− 1/2 where w / 2 and h / 2 are meant", lab =>
            {
                lab.Uc.Becomes(uc => c => uc(c) - uc(0) - 0.5);
                lab.Ur.Becomes(ur => r => ur(r) - ur(0) - 0.5);
            }),
        new("center", Concerns.Camera, Slides.PixelTranslation,
            "the ray passes the pixel's centre where its corner is meant (its corner where the centre is meant)",
            lab => lab.Sample.Becomes(sample =>
            {
                var half = lab.Camera.Sample == Sample.Corner ? 0.5 : -0.5;
                return (c, r) => sample(c + half, r + half);
            }),
            "Only outlines differ: everything is half a pixel off.",
            "Where in its pixel does the scene's \"sample\" want the ray?",
            "For corners uc = w c / width − w / 2; for centres c + 0.5 and r + 0.5 take the places of c and r."),
        new Mistake("wm1", Concerns.Camera, Slides.PixelTranslation, "c / (width − 1) and r / (height − 1)",
            lab => Count(lab, -1, -1),
            "Only outlines differ: not at the lower left, and ever more towards the right and the top, up to a pixel.",
            "By what does the slide divide c?",
            "uc = w c / width − w / 2, ur = h r / height − h / 2.")
            .Or("only c / (width − 1)", lab => Count(lab, -1, 0))
            .Or("only r / (height − 1)", lab => Count(lab, 0, -1))
            .Or("c / (width + 1) and r / (height + 1)", lab => Count(lab, 1, 1)),
        new Mistake("size-mixed", Concerns.Camera, Slides.PixelTranslation,
            "width and height swapped in the mapping: uc = w c / height − w / 2, ur = h r / width − h / 2",
            lab =>
            {
                lab.Uc.Becomes(uc => c => uc(c * lab.Wide));
                lab.Ur.Becomes(ur => r => ur(r * lab.Tall));
            },
            "The picture is stretched or pressed along one side or both, and not centred.",
            "Which side of the picture do columns count along?",
            "uc = w c / width − w / 2, ur = h r / height − h / 2.")
            .Or("only uc = w c / height − w / 2", lab => lab.Uc.Becomes(uc => c => uc(c * lab.Wide)))
            .Or("only ur = h r / width − h / 2", lab => lab.Ur.Becomes(ur => r => ur(r * lab.Tall)))
            .Or("uc = w c / width − h / 2, ur = h r / height − w / 2", lab =>
            {
                lab.Uc.Becomes(uc => c => uc(c) - uc(0) + uc(0) * lab.Tall);
                lab.Ur.Becomes(ur => r => ur(r) - ur(0) + ur(0) * lab.Wide);
            }),
    ];

    /// <summary>w and h, each so many times what they are.</summary>
    private static void Stretch(Lab lab, double w, double h)
    {
        lab.PlaneHeight.Becomes(height => fovY => h * height(fovY));
        lab.PlaneWidth.Becomes(width => height => w / h * width(height));
    }

    /// <summary>uc and ur with other shares of w and h taken off than a half.</summary>
    private static void Shift(Lab lab, double ofW, double ofH)
    {
        lab.Uc.Becomes(uc => c => uc(c) + (2 * ofW - 1) * uc(0));
        lab.Ur.Becomes(ur => r => ur(r) + (2 * ofH - 1) * ur(0));
    }

    /// <summary>c / (width + i) and r / (height + k).</summary>
    private static void Count(Lab lab, int i, int k)
    {
        if (i != 0) lab.Uc.Becomes(uc => c => uc(c * lab.Camera.Width / (lab.Camera.Width + i)));
        if (k != 0) lab.Ur.Becomes(ur => r => ur(r * lab.Camera.Height / (lab.Camera.Height + k)));
    }
}
