namespace RayCaster.Teaching;

/// <summary>Between the pixels and the file: how it reads to those who open it.</summary>
internal static class FileMistakes
{
    public static Mistake[] All =>
    [
        new("rows", Concerns.File, Slides.Picture, "row r written as line r, not as line height − 1 − r",
            lab => lab.Row.Becomes(row => y => row(lab.Camera.Height - 1 - y)))
        {
            Hint = new("The picture is upside down.",
                "Row 0 of the slide is at the bottom. Where is line 0 of a picture?",
                "Line y = height − 1 − r."),
        },
        new("cols", Concerns.File, Slides.Picture, "columns written from the right",
            lab => lab.Column.Becomes(column => x => column(lab.Camera.Width - 1 - x)))
        {
            Hint = new("The picture is mirrored left to right.",
                "Column 0 is at the left, in the slide and in the file. Is it in yours?",
                "Column x = c."),
        },
        new Mistake("transpose", Concerns.File, Slides.Picture, "row and column swapped in the picture",
            lab =>
            {
                lab.SwapSides();
                lab.Shown.Becomes(shown => (x, y) => shown(y, x));
            })
        {
            Hint = new("The picture is mirrored at its diagonal.",
                "Which index comes first where you store a pixel, and which where you write it?",
                "Pixel (x, y) is column x of line y; lines are written one after another."),
        }
        .Or("row and column swapped when the ray is cast", lab => lab.Sample.Becomes(sample => (c, r) => sample(r, c))),
        new("bgr", Concerns.File, Slides.Picture, "red and blue swapped",
            lab => lab.Shown.Becomes(shown => (x, y) =>
            {
                var (r, g, b) = shown(x, y);
                return (b, g, r);
            }))
        {
            Hint = new("What should be red is blue, and what should be blue is red.",
                "In which order does the file format want the three bytes?",
                "Red, green, blue."),
        },
        new("whswap", Concerns.File, Slides.Picture, "width and height swapped in the file's header",
            lab =>
            {
                lab.SwapSides();
                var (old, now) = (lab.Height, lab.Width);
                lab.Shown.Becomes(shown => (x, y) => shown((y * now + x) % old, (y * now + x) / old));
            })
        {
            Hint = new("The picture is sheared into stripes, and its sides are swapped.",
                "Which of the two numbers comes first in the header?",
                "Width, then height."),
        },
        new("crlf", Concerns.File, Slides.Picture, "one byte too many between the header and the pixels",
            lab =>
            {
                var width = lab.Width;
                lab.Shown.Becomes(shown => (x, y) =>
                {
                    var (r, g, _) = shown(x, y);
                    var before = (x, y) == (0, 0) ? (byte)'\n' : x > 0 ? shown(x - 1, y).B : shown(width - 1, y - 1).B;
                    return (before, r, g);
                });
            })
        {
            Hint = new("The colours have moved on: what should be red is green, green is blue, blue is red.",
                "Which bytes follow the 255 of the header, and how many?",
                "Exactly one white-space byte, then the pixels: write \"\\n\", not WriteLine, which ends with \"\\r\\n\" on Windows."),
        },
        new("row-off", Concerns.File, Slides.Picture, "line y shows row height − y, not height − 1 − y",
            lab => lab.Row.Becomes(row => y => row(y) + 1))
        {
            Hint = new("The picture is one line too low.",
                "Rows count from 0. Which is the highest?",
                "Line y shows row r = height − 1 − y."),
        },
    ];
}
