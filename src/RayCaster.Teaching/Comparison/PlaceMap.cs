namespace RayCaster.Teaching.Comparison;

/// <summary>The second way to be wrong: the right pixels at other places.</summary>
/// <param name="Words">What makes the picture right, as the beginning of a sentence on it.</param>
/// <param name="Question">The usual cause, as a question.</param>
/// <param name="Places">
/// For a picture and the right one: where the first byte of the pixel lies that belongs to a column and line; null if the sizes do not fit. A place
/// outside of the picture is unknown.
/// </param>
internal sealed record PlaceMap(string Words, string Question, Func<Picture, Picture, Func<int, int, int>?> Places)
{
    private const string Loop = "does a loop or an index begin too early or too late?";

    /// <summary>What may remain wrong: this share of all pixels, and of those that were wrong.</summary>
    private const double MostLeft = 0.02, MostOfWrong = 0.1;

    private static readonly PlaceMap[] all =
    [
        Turned("flipped top to bottom", "are rows written upside down?", (x, y, w, h) => (x, h - 1 - y)),
        Turned("mirrored left to right", "are columns written from the right?", (x, y, w, h) => (w - 1 - x, y)),
        Turned("turned by 180°", "are rows and columns both written from the wrong end?", (x, y, w, h) => (w - 1 - x, h - 1 - y)),
        Transposed("transposed", (x, y, w, h) => (y, x)),
        Transposed("turned by 90° clockwise", (x, y, w, h) => (y, w - 1 - x)),
        Transposed("turned by 90° counter-clockwise", (x, y, w, h) => (h - 1 - y, x)),
        Transposed("transposed and turned by 180°", (x, y, w, h) => (h - 1 - y, w - 1 - x)),
        Turned("moved 1 pixel to the right", Loop, (x, y, w, h) => (x - 1, y)),
        Turned("moved 1 pixel to the left", Loop, (x, y, w, h) => (x + 1, y)),
        Turned("moved 1 line down", Loop, (x, y, w, h) => (x, y - 1)),
        Turned("moved 1 line up", Loop, (x, y, w, h) => (x, y + 1)),
        Turned("flipped top to bottom and moved 1 line down", "are rows written upside down, and one too far?", (x, y, w, h) => (x, h - y)),
        Turned("flipped top to bottom and moved 1 line up", "are rows written upside down, and one too early?", (x, y, w, h) => (x, h - 2 - y)),
        .. ((int[])[1, 2, 3, 4]).SelectMany(bytes => (PlaceMap[])
        [
            new($"with its bytes moved by {bytes} towards the beginning", "does the header end with bytes that do not belong there?",
                (mine, right) => IsOfSize(mine, right.Width, right.Height) ? (x, y) => 3 * (y * right.Width + x) + bytes : null),
            new($"with its bytes moved by {bytes} towards the end", "does the program write too few bytes after the header?",
                (mine, right) => IsOfSize(mine, right.Width, right.Height) ? (x, y) => 3 * (y * right.Width + x) - bytes : null),
        ]),
        .. ((int[])[1, 2, 3, 4, 6, -1, -2, -3, -4, -6]).SelectMany(bytes => (PlaceMap[])[Skipped(bytes), Inserted(bytes)]),
        new("with width and height swapped in its header", "does the program write the height first?",
            (mine, right) => right.Width != right.Height && IsOfSize(mine, right.Height, right.Width) ? (x, y) => 3 * (y * right.Width + x) : null),
    ];

    /// <summary>A change of places that makes a picture right, or nearly so; null if there is none.</summary>
    /// <param name="judge">Of the right picture.</param>
    /// <param name="wrong">How many pixels are wrong; null if the sizes differ.</param>
    public static Explanation? Find(Picture mine, Picture right, PictureJudge judge, int? wrong)
    {
        if (mine.IsNearlyOneColor || right.IsNearlyOneColor) return null; // any change of places gives the same picture
        var count = right.Count;
        var most = (int)Math.Min(MostLeft * count, wrong is { } some ? MostOfWrong * some : count);
        (PlaceMap Map, PictureDifference Left)? best = null;
        foreach (var map in all)
        {
            if (map.Places(mine, right) is not { } place || Undone(mine, right, place, most) is not { } undone) continue;
            var rest = new PictureDifference(undone, right);
            if (best is not { } other || rest.Wrong < other.Left.Wrong) best = (map, rest);
        }
        if (best is not var (found, left)) return null;
        var isRight = judge.Compare(left) != Likeness.Wrong;
        return new(Way.Places, $"{char.ToUpperInvariant(found.Words[0])}{found.Words[1..]} it is " +
            (!isRight ? $"nearly right, but for {Digits.Part(left.Wrong, left.Pixels)}" : left.Wrong > 0 ? "right but for pixels on outlines"
                : "right") +
            $": {found.Question}", Priors.Places, Priors.WeightOf(isRight ? 0 : left.Wrong, left.OffByOne));
    }

    /// <summary>The picture with each pixel at its place, where a place is unknown with the right one; null if more pixels are wrong than may be.
    /// </summary>
    private static Picture? Undone(Picture mine, Picture right, Func<int, int, int> place, int most)
    {
        var undone = new Picture(right.Width, right.Height);
        var (wrong, unknown) = (0, 0);
        for (var y = 0; y < right.Height; y++)
        {
            for (var x = 0; x < right.Width; x++)
            {
                var at = place(x, y);
                if (at < 0 || at + 3 > mine.Rgb.Length)
                {
                    undone[x, y] = right[x, y];
                    unknown++;
                }
                else
                {
                    undone[x, y] = (mine.Rgb[at], mine.Rgb[at + 1], mine.Rgb[at + 2]);
                    if (!PictureJudge.IsNear(undone[x, y], right[x, y]) && ++wrong > most) return null;
                }
            }
        }
        return 4 * unknown > right.Count ? null : undone;
    }

    private static PlaceMap Turned(string words, string question, Func<int, int, int, int, (int X, int Y)> place) =>
        new(words, question, (mine, right) => IsOfSize(mine, right.Width, right.Height) ? At(mine, right, place) : null);

    private static PlaceMap Transposed(string words, Func<int, int, int, int, (int X, int Y)> place) => new(words, "are rows and columns swapped?",
        (mine, right) => IsOfSize(mine, right.Height, right.Width) ? At(mine, right, place) : null);

    private static Func<int, int, int> At(Picture mine, Picture right, Func<int, int, int, int, (int X, int Y)> place) => (x, y) =>
    {
        var (fromX, fromY) = place(x, y, right.Width, right.Height);
        return (uint)fromX < (uint)mine.Width && (uint)fromY < (uint)mine.Height ? 3 * (fromY * mine.Width + fromX) : -1;
    };

    /// <summary>Each line begins some bytes later in the right picture's bytes than the line above ends.</summary>
    private static PlaceMap Skipped(int bytes) => OfLines(bytes, (mine, right) => (x, y) =>
    {
        var (line, at) = Math.DivRem(3 * (y * right.Width + x), 3 * right.Width + bytes);
        return at + 3 <= 3 * right.Width ? 3 * right.Width * line + at : -1;
    });

    /// <summary>There are some bytes more in the picture after each line.</summary>
    private static PlaceMap Inserted(int bytes) => OfLines(bytes, (mine, right) => (x, y) => (3 * right.Width + bytes) * y + 3 * x);

    private static PlaceMap OfLines(int bytes, Func<Picture, Picture, Func<int, int, int>> places) => new(
        $"with each line moved by {Digits.Count(Math.Abs(bytes), "byte")} more than the one above",
        "how many bytes does a line have where it is written, and where it is copied from? Some formats fill each line up to 4 bytes.",
        (mine, right) => IsOfSize(mine, right.Width, right.Height) ? places(mine, right) : null);

    private static bool IsOfSize(Picture picture, int width, int height) => (picture.Width, picture.Height) == (width, height);
}
