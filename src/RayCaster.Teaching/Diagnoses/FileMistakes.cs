namespace RayCaster.Teaching;

/// <summary>Between the pixels and the file: how it reads to those who open it.</summary>
internal static class FileMistakes
{
    public static Mistake[] All =>
    [
        new Mistake("rows", Affects.File, Slides.Template, "row r written as line r, not as line height − 1 − r",
            lab => lab.Row.Becomes(row => y => row(lab.Camera.Height - 1 - y)),
            "The picture is upside down.",
            "Row 0 of the slide is at the bottom. Where is line 0 of a picture?",
            "Line y = height − 1 − r.")
            .Or("row r written as line r + 1", lab => lab.Row.Becomes(row => y => row(lab.Camera.Height - y))),
        new("cols", Affects.File, Slides.Template, "columns written from the right",
            lab => lab.Column.Becomes(column => x => column(lab.Camera.Width - 1 - x)),
            "The picture is mirrored left to right.",
            "Column 0 is at the left, in the slide and in the file. Is it in yours?",
            "Column x = c."),
        new Mistake("transpose", Affects.File, Slides.Template, "row and column swapped in the picture",
            Turned((x, y, _, _) => (y, x)),
            "The picture is mirrored at its diagonal.",
            "Which index comes first where you store a pixel, and which where you write it?",
            "Pixel (x, y) is column x of line y; lines are written one after another.")
            .Or("the picture turned by 90 degrees", Turned((x, y, width, _) => (y, width - 1 - x)))
            .Or("the picture turned by 90 degrees, the other way", Turned((x, y, _, height) => (height - 1 - y, x)))
            .Or("row and column swapped, both counted from the other end", Turned((x, y, width, height) => (height - 1 - y, width - 1 - x)))
            .Or("the pixels are written column by column", ByColumns(down: true))
            .Or("the pixels are written column by column, from the bottom", ByColumns(down: false))
            .Or("line y begins at y · height, where y · width is meant", Stride(fromTop: true))
            .Or("line y begins at y · height, and the lowest line is written first", Stride(fromTop: false)),
        new Mistake("bgr", Affects.File, Slides.Template, "red and blue swapped",
            Order("bgr"),
            "Two colours are swapped: what should be red is blue, say.",
            "In which order does the file format want the three bytes?",
            "Red, green, blue.")
            .Or(from order in (string[])["grb", "rbg", "gbr", "brg", "rrr", "rrb", "rgr", "rgg", "ggb", "bgb", "rbb"]
                select ($"the bytes are {order[0]}, {order[1]} and {order[2]}", Order(order))),
        new("whswap", Affects.File, Slides.Template, "width and height swapped in the file's header",
            Turned((x, y, width, height) => ((y * width + x) % height, (y * width + x) / height)),
            "The picture is sheared into stripes, and its sides are swapped.",
            "Which of the two numbers comes first in the header?",
            "Width, then height."),
        new Mistake("crlf", Affects.File, Slides.Template, "one byte too many between the header and the pixels",
            Bytes(1),
            "The colours have moved on: what should be red is green, green is blue, blue is red.",
            "Which bytes follow the 255 of the header, and how many?",
            "Exactly one white-space byte, then the pixels: write \"\\n\", not WriteLine, which ends with \"\\r\\n\" on Windows.")
            .Or(from many in (int[])[2, 3, -1, -2, -3]
                select ($"{Math.Abs(many)} bytes too {(many > 0 ? "many" : "few")} between the header and the pixels", Bytes(many))),
        new Mistake("row-off", Affects.File, Slides.Template, "line y shows row height − y, not height − 1 − y",
            lab => lab.Row.Becomes(row => y => row(y) + 1),
            "The picture is one line or one column off.",
            "Rows count from 0. Which is the highest?",
            "Line y shows row r = height − 1 − y.")
            .Or("column x shows column x + 1", lab => lab.Column.Becomes(column => x => column(x) + 1))
            .Or("column x shows column x − 1", lab => lab.Column.Becomes(column => x => column(x) - 1))
            .Or(from many in (int[])[1, -1]
                select ($"the picture's columns are moved round by {many}", (Action<Lab>)(lab => lab.Column.Becomes(column =>
                    x => (column(x) + many + lab.Camera.Width) % lab.Camera.Width))))
            .Or("rows and columns counted from 1", lab => lab.Sample.Becomes(sample => (c, r) => sample(c + 1, r + 1)))
            .Or("line y shows row height − y, line 0 row 0", lab => lab.Row.Becomes(row => y => (row(y) + 1) % lab.Camera.Height))
            .Or("line y shows row height − y, line 0 none", Unwritten((x, y, width, height) => y == 0,
                lab => lab.Row.Becomes(row => y => row(y) + 1)))
            .Or("line y shows row height − 2 − y, the last line none", Unwritten((x, y, width, height) => y == height - 1,
                lab => lab.Row.Becomes(row => y => row(y) - 1)))
            .Or("column x shows column x − 1, column 0 none", Unwritten((x, y, width, height) => x == 0,
                lab => lab.Column.Becomes(column => x => column(x) - 1)))
            .Or(from left in (string[])["first", "last"]
                from sides in (string[])["row and column", "row", "column"]
                select ($"the {left} {sides} are not drawn", Unwritten((x, y, width, height) =>
                    (sides != "row" && x == (left == "first" ? 0 : width - 1)) || (sides != "column" && y == (left == "first" ? height - 1 : 0))))),
    ];

    /// <summary>Width and height swapped, and (x, y, width, height) of the file → the place in the picture that it shows.</summary>
    private static Action<Lab> Turned(Func<int, int, int, int, (int X, int Y)> place) => lab =>
    {
        lab.SwapSides();
        var (width, height) = (lab.Width, lab.Height);
        lab.Shown.Becomes(shown => (x, y) =>
        {
            var from = place(x, y, width, height);
            return shown(from.X, from.Y);
        });
    };

    /// <summary>The file has the picture's columns one after another.</summary>
    private static Action<Lab> ByColumns(bool down) => lab => lab.Shown.Becomes(shown =>
    {
        var (width, height) = (lab.Camera.Width, lab.Camera.Height);
        return (x, y) =>
        {
            var (column, place) = Math.DivRem(y * width + x, height);
            return shown(column, down ? place : height - 1 - place);
        };
    });

    /// <summary>Lines that begin height pixels after one another and cover each other in the order in which they are written.</summary>
    private static Action<Lab> Stride(bool fromTop) => lab => lab.Shown.Becomes(shown =>
    {
        var (width, height) = (lab.Camera.Width, lab.Camera.Height);
        return (x, y) =>
        {
            var place = y * width + x;
            var first = place < width ? 0 : Math.Max(0, (place - width) / height + 1); // of the lines that reach there
            var last = Math.Min(place / height, height - 1);
            return first <= last ? shown(place - (fromTop ? last : first) * height, fromTop ? last : first) : default;
        };
    });

    /// <summary>Some pixels stay black, by their place and the picture's sides.</summary>
    private static Action<Lab> Unwritten(Func<int, int, int, int, bool> isLeftOut, Action<Lab>? besides = null) => besides + (lab =>
        lab.Shown.Becomes(shown => (x, y) => isLeftOut(x, y, lab.Width, lab.Height) ? default : shown(x, y)));

    /// <summary>The channels in another order, or one of them in the place of another.</summary>
    private static Action<Lab> Order(string order) => lab => lab.Shown.Becomes(shown => (x, y) =>
    {
        var shows = shown(x, y);
        return (Channel(0), Channel(1), Channel(2));

        byte Channel(int place) => order[place] switch { 'r' => shows.R, 'g' => shows.G, _ => shows.B };
    });

    /// <summary>All bytes so many places farther on in the file; what is before the first is a line break.</summary>
    private static Action<Lab> Bytes(int many) => lab => lab.Read.Becomes(read => (x, y) =>
    {
        var first = 3 * (y * lab.Width + x);
        return (At(first), At(first + 1), At(first + 2));

        byte At(int place)
        {
            if ((uint)(place -= many) >= (uint)(3 * lab.Width * lab.Height)) return (byte)'\n';
            var (r, g, b) = read(place / 3 % lab.Width, place / 3 / lab.Width);
            return (place % 3) switch { 0 => r, 1 => g, _ => b };
        }
    });
}
