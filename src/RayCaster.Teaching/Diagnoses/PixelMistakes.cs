namespace RayCaster.Teaching;

/// <summary>Between a pixel and its place in the plane of the picture.</summary>
internal static class PixelMistakes
{
    public static Mistake[] All =>
    [
        new Mistake("pix-int", Affects.Camera, Slides.PixelTranslation, "w · (c / width), divided in integers: always 0",
            Both(Whole(1)),
            "The picture has one colour, or stripes: all rays of it, of a line or of a column are the same.",
            "What is c / width in C#, where both are int?",
            "uc = w · c / width − w / 2, from left to right: w is a double, so no integers are divided.")
            .Or("only c / width is divided in integers", Columns(Whole(1)))
            .Or("only r / height is divided in integers", Rows(Whole(1)))
            .Or(Each("2 c / width − 1", "2 r / height − 1", ", divided in integers", Whole(2)))
            .Or(Each("(2 c − width) / height", "(2 r − height) / height", ", divided in integers",
                (side, u, x) => Math.Truncate(u(x) / side.Lab.HalfHeight) * side.Lab.HalfHeight)),
        new Mistake("no-center", Affects.Camera, Slides.PixelTranslation, "uc and ur without − w / 2 and − h / 2",
            Both(Less(0)),
            "What should be in the middle is at a corner or at an edge.",
            "Which pixel has uc = 0 and ur = 0?",
            "uc = w c / width − w / 2, ur = h r / height − h / 2.")
            .Or("uc without − w / 2", Columns(Less(0)))
            .Or("ur without − h / 2", Rows(Less(0)))
            .Or("− w and − h where their halves are meant", Both(Less(1)))
            .Or("+ w / 2 and + h / 2", Both(Less(-0.5)))
            .Or("+ w / 2 for − w / 2", Columns(Less(-0.5)))
            .Or("+ h / 2 for − h / 2", Rows(Less(-0.5)))
            .Or("(w c / width − w) / 2 and (h r / height − h) / 2: wrong brackets", Both(Halved))
            .Or("(w c / width − w) / 2", Columns(Halved))
            .Or("(h r / height − h) / 2", Rows(Halved))
            .Or(Each("w (c / width − w / 2)", "h (r / height − h / 2)", "", (_, u, x) => u(x) - u(0) - 2 * u(0) * u(0))) // u(0) = − w / 2
            .Or("− w for − w / 2", Columns(Less(1)))
            .Or("− h for − h / 2", Rows(Less(1)))
            .Or("− 1/2 where w / 2 and h / 2 are meant", Both((_, u, x) => u(x) - u(0) - 0.5))
            .In(FromTop),
        new Mistake("center", Affects.Camera, Slides.PixelTranslation,
            "the ray passes the pixel's centre where its corner is meant (its corner where the centre is meant)",
            Sampled(1, 1),
            "Only outlines differ: everything is half a pixel off.",
            "Where in its pixel does the scene's \"sample\" want the ray?",
            "For corners uc = w c / width − w / 2; for centres c + 0.5 and r + 0.5 take the places of c and r.")
            .Or("the same for columns alone", Sampled(1, 0))
            .Or("the same for rows alone", Sampled(0, 1)),
        new Mistake("wm1", Affects.Camera, Slides.PixelTranslation, "c / (width − 1) and r / (height − 1)",
            Both(OneLess),
            "Only outlines differ: not at the lower left, and ever more towards the right and the top, up to a pixel.",
            "By what does the slide divide c?",
            "uc = w c / width − w / 2, ur = h r / height − h / 2.")
            .Or("only c / (width − 1)", Columns(OneLess))
            .Or("only r / (height − 1)", Rows(OneLess))
            .In(FromTop),
        new Mistake("size-mixed", Affects.Camera, Slides.PixelTranslation,
            "width and height swapped in the mapping: uc = w c / height − w / 2, ur = h r / width − h / 2",
            SidesMixed().First().Deviate,
            "The picture is stretched or pressed along one side or both, and not centred.",
            "Which side of the picture do columns count along?",
            "uc = w c / width − w / 2, ur = h r / height − h / 2.")
            .Or(SidesMixed().Skip(1))
            .In(FromTop),
    ];

    /// <summary>Another place in the plane, uc or ur: from the side, the right formula and the column or row.</summary>
    private delegate double Place(Side side, Func<double, double> u, double x);

    /// <summary>The picture's width, along which columns count, or its height, along which rows count.</summary>
    private readonly record struct Side(Lab Lab, bool IsWidth)
    {
        public int Pixels => IsWidth ? Lab.Camera.Width : Lab.Camera.Height;

        /// <summary>What makes this side of the other one: 1 in the picture, −1 in the plane; 0 leaves it.</summary>
        public double Factor(int which) => (which, IsWidth) switch
        {
            (1, true) => Lab.Wide,
            (1, false) => Lab.Tall,
            (-1, true) => Lab.PlaneTall,
            (-1, false) => 1 / Lab.PlaneTall,
            _ => 1,
        };
    }

    private static Action<Lab> Columns(Place place) => lab => lab.Uc.Becomes(uc => c => place(new(lab, true), uc, c));

    private static Action<Lab> Rows(Place place) => lab => lab.Ur.Becomes(ur => r => place(new(lab, false), ur, r));

    private static Action<Lab> Both(Place place) => Columns(place) + Rows(place);

    /// <summary>A mistake made in both formulas, in uc alone, and in ur alone.</summary>
    private static (string, Action<Lab>)[] Each(string uc, string ur, string what, Place place) =>
        [($"{uc} and {ur}{what}", Both(place)), ($"{uc}{what}", Columns(place)), ($"{ur}{what}", Rows(place))];

    /// <summary>ur = h / 2 − h (height − r) / height: another right way, in which a wrong step is counted from the upper edge.</summary>
    private static (string Cause, Action<Lab> Deviate) FromTop =>
        ("rows are counted from the top", lab => lab.Ur.Becomes(ur => r => -ur(lab.Camera.Height - r)));

    /// <summary>Columns or rows in so many steps.</summary>
    private static Place Whole(int steps) => (side, u, x) => u(side.Pixels * Math.Floor(steps * x / side.Pixels) / steps);

    /// <summary>Another share of w or h taken off than a half.</summary>
    private static Place Less(double share) => (_, u, x) => u(x) + (2 * share - 1) * u(0);

    private static Place Halved => (_, u, x) => (u(x) + u(0)) / 2;

    private static Place OneLess => (side, u, x) => u(x * side.Pixels / (side.Pixels - 1));

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
            Place mixed = (side, u, x) => side.Factor(step) * (u(x) - u(0)) + side.Factor(start) * u(0);
            yield return ($"uc = {ofUc}, ur = {ofUr}", Both(mixed));
            yield return ($"only uc = {ofUc}", Columns(mixed));
            yield return ($"only ur = {ofUr}", Rows(mixed));
            yield return ($"only ur = {ofUr}, counted from the top",
                Rows(mixed) + (lab => lab.Ur.Becomes(ur => r => -ur(lab.Camera.Height - r))));
        }
    }

    /// <summary>Half a pixel farther or nearer than the scene says; 1 is from the corner to the centre, or from the centre to the corner.</summary>
    private static Action<Lab> Sampled(int columns, int rows) => lab => lab.Sample.Becomes(sample =>
    {
        var half = lab.Camera.Sample == PixelSample.Corner ? 0.5 : -0.5;
        return (c, r) => sample(c + columns * half, r + rows * half);
    });
}
