namespace RayCaster.Teaching;

/// <summary>Between a pixel and its place in the plane of the picture.</summary>
internal static class PixelMistakes
{
    public static Mistake[] All =>
    [
        new("pix-int", Affects.Camera, Slides.PixelTranslation, "w · (c / width), divided in integers: always 0",
            Both((u, x, pixels) => u(pixels * Math.Floor(x / pixels))),
            "The picture has one colour, or stripes: all rays of it, of a line or of a column are the same.",
            "What is c / width in C#, where both are int?",
            "uc = w · c / width − w / 2, from left to right: w is a double, so no integers are divided."),
        new("no-center", Affects.Camera, Slides.PixelTranslation, "uc and ur without − w / 2 and − h / 2",
            Both((u, x, _) => u(x) - u(0)), // u(0) = − w / 2
            "What should be in the middle is at a corner or at an edge.",
            "Which pixel has uc = 0 and ur = 0?",
            "uc = w c / width − w / 2, ur = h r / height − h / 2."),
        new("center", Affects.Camera, Slides.PixelTranslation,
            "the ray passes the pixel's centre where its corner is meant (its corner where the centre is meant)",
            lab => lab.Sample.Becomes(sample =>
            {
                var half = lab.Camera.Sample == PixelSample.Corner ? 0.5 : -0.5;
                return (c, r) => sample(c + half, r + half);
            }),
            "Only outlines differ: everything is half a pixel off.",
            "Where in its pixel does the scene's \"sample\" want the ray?",
            "For corners uc = w c / width − w / 2; for centres c + 0.5 and r + 0.5 take the places of c and r."),
        new("wm1", Affects.Camera, Slides.PixelTranslation, "c / (width − 1) and r / (height − 1)",
            Both((u, x, pixels) => u(x * pixels / (pixels - 1))),
            "Only outlines differ: not at the lower left, and ever more towards the right and the top, up to a pixel.",
            "By what does the slide divide c?",
            "uc = w c / width − w / 2, ur = h r / height − h / 2."),
        new Mistake("rc-swap", Affects.Camera, Slides.PixelTranslation, "c and r swapped when the ray is cast",
            lab => lab.Sample.Becomes(sample => (c, r) => sample(r, c)),
            "The picture is mirrored at its rising diagonal; one that is not square is deformed or cut off, too.",
            "Columns are counted by c, rows by r. In which order does each call take them, and which of them goes with width?",
            "uc = w c / width − w / 2, ur = h r / height − h / 2.")
            .Or("c and r swapped when the ray is cast, each divided by its own side",
                lab => lab.Sample.Becomes(sample => (c, r) => sample(r * lab.Wide, c * lab.Tall))),
        new("size-mixed", Affects.Camera, Slides.PixelTranslation,
            "width and height swapped in the mapping: uc = w c / height − w / 2, ur = h r / width − h / 2",
            lab =>
            {
                lab.Uc.Becomes(uc => c => lab.Wide * (uc(c) - uc(0)) + uc(0));
                lab.Ur.Becomes(ur => r => lab.Tall * (ur(r) - ur(0)) + ur(0));
            },
            "The picture is stretched or pressed along one side or both, and not centred.",
            "Which side of the picture do columns count along?",
            "uc = w c / width − w / 2, ur = h r / height − h / 2."),
    ];

    /// <summary>Another place in the plane for uc and for ur: from the right formula, the column or row, and how many there are.</summary>
    private static Action<Lab> Both(Func<Func<double, double>, double, int, double> place) => lab =>
    {
        lab.Uc.Becomes(uc => c => place(uc, c, lab.Camera.Width));
        lab.Ur.Becomes(ur => r => place(ur, r, lab.Camera.Height));
    };
}
