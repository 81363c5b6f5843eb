namespace RayCaster.Teaching;

/// <summary>Between a pixel and its place in the plane of the picture.</summary>
internal static class PixelMistakes
{
    public static Mistake[] All =>
    [
        new Mistake("pix-int", Concerns.Camera, Slides.PixelTranslation, "w · (c / width), divided in integers: always 0",
            WholeColumns(1) + WholeRows(1),
            "The picture has one colour, or stripes: all rays of it, of a line or of a column are the same.",
            "What is c / width in C#, where both are int?",
            "uc = w · c / width − w / 2, from left to right: w is a double, so no integers are divided.")
            .Or("only c / width is divided in integers", WholeColumns(1))
            .Or("only r / height is divided in integers", WholeRows(1))
            .Or("2 c / width − 1 and 2 r / height − 1, divided in integers", WholeColumns(2) + WholeRows(2))
            .Or("2 c / width − 1, divided in integers", WholeColumns(2))
            .Or("2 r / height − 1, divided in integers", WholeRows(2))
            .Or("(2 c − width) / height and (2 r − height) / height, divided in integers", WholeUc + WholeUr)
            .Or("(2 c − width) / height, divided in integers", WholeUc)
            .Or("(2 r − height) / height, divided in integers", WholeUr),
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
            .Or("(w c / width − w) / 2 and (h r / height − h) / 2: wrong brackets", HalveC + HalveR)
            .Or("(w c / width − w) / 2", HalveC)
            .Or("(h r / height − h) / 2", HalveR)
            .Or("w (c / width − w / 2) and h (r / height − h / 2)", BracketC + BracketR)
            .Or("w (c / width − w / 2)", BracketC)
            .Or("h (r / height − h / 2)", BracketR)
            .Or("− w for − w / 2", lab => Shift(lab, 1, 0.5))
            .Or("− h for − h / 2", lab => Shift(lab, 0.5, 1))
            .Or("− 1/2 where w / 2 and h / 2 are meant", lab =>
            {
                lab.Uc.Becomes(uc => c => uc(c) - uc(0) - 0.5);
                lab.Ur.Becomes(ur => r => ur(r) - ur(0) - 0.5);
            }),
        new Mistake("center", Concerns.Camera, Slides.PixelTranslation,
            "the ray passes the pixel's centre where its corner is meant (its corner where the centre is meant)",
            Sampled(1, 1),
            "Only outlines differ: everything is half a pixel off.",
            "Where in its pixel does the scene's \"sample\" want the ray?",
            "For corners uc = w c / width − w / 2; for centres c + 0.5 and r + 0.5 take the places of c and r.")
            .Or("the same for columns alone", Sampled(1, 0))
            .Or("the same for rows alone", Sampled(0, 1)),
        new Mistake("wm1", Concerns.Camera, Slides.PixelTranslation, "c / (width − 1) and r / (height − 1)",
            lab => Count(lab, -1, -1),
            "Only outlines differ: not at the lower left, and ever more towards the right and the top, up to a pixel.",
            "By what does the slide divide c?",
            "uc = w c / width − w / 2, ur = h r / height − h / 2.")
            .Or("only c / (width − 1)", lab => Count(lab, -1, 0))
            .Or("only r / (height − 1)", lab => Count(lab, 0, -1)),
        new Mistake("size-mixed", Concerns.Camera, Slides.PixelTranslation,
            "width and height swapped in the mapping: uc = w c / height − w / 2, ur = h r / width − h / 2",
            SidesMixed().First().Deviate,
            "The picture is stretched or pressed along one side or both, and not centred.",
            "Which side of the picture do columns count along?",
            "uc = w c / width − w / 2, ur = h r / height − h / 2.")
            .Or(SidesMixed().Skip(1)),
    ];

    /// <summary>Columns in so many steps, rows likewise.</summary>
    private static Action<Lab> WholeColumns(int steps) =>
        lab => lab.Uc.Becomes(uc => c => uc(lab.Camera.Width * Math.Floor(steps * c / lab.Camera.Width) / steps));

    private static Action<Lab> WholeRows(int steps) =>
        lab => lab.Ur.Becomes(ur => r => ur(lab.Camera.Height * Math.Floor(steps * r / lab.Camera.Height) / steps));

    /// <summary>uc in whole halves of h.</summary>
    private static Action<Lab> WholeUc => lab => lab.Uc.Becomes(uc => c => Math.Truncate(uc(c) / lab.HalfHeight) * lab.HalfHeight);

    private static Action<Lab> WholeUr => lab => lab.Ur.Becomes(ur => r => Math.Truncate(ur(r) / lab.HalfHeight) * lab.HalfHeight);

    /// <summary>Each place where a letter of the picture's other side may stand in uc and in ur; first both divided by the other side.</summary>
    private static IEnumerable<(string Cause, Action<Lab> Deviate)> SidesMixed()
    {
        (string Uc, string Ur, int Step, int Start)[] slips =
        [
            ("w c / height − w / 2", "h r / width − h / 2", 1, 0),
            ("w c / width − h / 2", "h r / height − w / 2", 0, -1),
            ("h c / width − w / 2", "w r / height − h / 2", -1, 0),
            ("w c / height − h / 2", "h r / width − w / 2", 1, -1),
            ("w (c − width / 2) / height", "h (r − height / 2) / width", 1, 1),
        ];
        foreach (var (ofUc, ofUr, step, start) in slips)
        {
            var (mixUc, mixUr) = (MixUc(step, start), MixUr(step, start));
            yield return ($"uc = {ofUc}, ur = {ofUr}", mixUc + mixUr);
            yield return ($"only uc = {ofUc}", mixUc);
            yield return ($"only ur = {ofUr}", mixUr);
            yield return ($"only ur = {ofUr}, counted from the top", mixUr + (lab => lab.Ur.Becomes(ur => r => -ur(lab.Camera.Height - r))));
        }
    }

    /// <summary>uc = w c / width − w / 2 with factors of both parts: 1 for width / height of the picture, −1 for h / w.</summary>
    private static Action<Lab> MixUc(int step, int start) => lab => lab.Uc.Becomes(uc => c =>
        Factor(step, lab.Wide, lab.PlaneTall) * (uc(c) - uc(0)) + Factor(start, lab.Wide, lab.PlaneTall) * uc(0));

    /// <summary>ur = h r / height − h / 2 with factors of both parts: 1 for height / width of the picture, −1 for w / h.</summary>
    private static Action<Lab> MixUr(int step, int start) => lab => lab.Ur.Becomes(ur => r =>
        Factor(step, lab.Tall, 1 / lab.PlaneTall) * (ur(r) - ur(0)) + Factor(start, lab.Tall, 1 / lab.PlaneTall) * ur(0));

    private static double Factor(int which, double ofPicture, double ofPlane) => which > 0 ? ofPicture : which < 0 ? ofPlane : 1;

    /// <summary>Half a pixel farther or nearer than the scene says; 1 is from the corner to the centre, or from the centre to the corner.</summary>
    private static Action<Lab> Sampled(int columns, int rows) => lab => lab.Sample.Becomes(sample =>
    {
        var half = lab.Camera.Sample == Sample.Corner ? 0.5 : -0.5;
        return (c, r) => sample(c + columns * half, r + rows * half);
    });

    private static Action<Lab> HalveC => lab => lab.Uc.Becomes(uc => c => (uc(c) + uc(0)) / 2);

    private static Action<Lab> HalveR => lab => lab.Ur.Becomes(ur => r => (ur(r) + ur(0)) / 2);

    /// <summary>w² / 2 is taken off, which is twice the square of uc(0) = − w / 2.</summary>
    private static Action<Lab> BracketC => lab => lab.Uc.Becomes(uc => c => uc(c) - uc(0) - 2 * uc(0) * uc(0));

    private static Action<Lab> BracketR => lab => lab.Ur.Becomes(ur => r => ur(r) - ur(0) - 2 * ur(0) * ur(0));

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
