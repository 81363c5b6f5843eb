namespace RayCaster.Teaching.Comparison;

/// <summary>A comparison in words.</summary>
public static class ComparisonText
{
    /// <summary>The verdict in a word or two.</summary>
    public static string Format(Likeness verdict) => verdict.Words;

    internal const string Cropped = "Was it cropped on its way, for example by a screenshot?";

    /// <summary>The comparison in whole lines.</summary>
    /// <param name="mine">The name of the picture in question.</param>
    /// <param name="reference">The name of the picture that it should be.</param>
    public static string Format(PictureComparison comparison, string mine, string reference)
    {
        if (comparison.Difference is not { } d)
        {
            var (a, b) = (comparison.Mine, comparison.Reference);
            var isSwapped = (a.Width, a.Height) == (b.Height, b.Width);
            return $"{mine} is wrong: it has {a.Width} x {a.Height} pixels, {reference} has {b.Width} x {b.Height}" +
                $"{(isSwapped ? ": width and height are swapped" : "")}.\n" +
                (comparison.Crop is { } crop ? $"It is the right picture without {crop.CroppedPart}. {Cropped}\n" : "")
                + OneColor(comparison, mine) + Observed(comparison);
        }
        return comparison.Likeness switch
        {
            Likeness.Identical => $"{mine} and {reference} are identical: {Digits.Count(d.Pixels, "pixel")}.\n",
            Likeness.WithinRounding => $"{mine} is right within rounding: {OffByOne(d)}, which is allowed for up to 1 % of them.\n",
            Likeness.OutlinesOnly => $"{mine} is right but for outlines: {Outlines(d)}, which is allowed.\n" +
                (d.OffByOne > 0 ? $"  Besides, {OffByOne(d)}.\n" : ""),
            Likeness.RoundedOtherwise => $"{mine} {RoundedOtherwise(d)}" +
                (d.Wrong > 0 ? $"  Besides, {Outlines(d)}, which is allowed.\n" : ""),
            _ => $"{mine} is wrong: {Digits.Part(d.Wrong, d.Pixels)} differ by more than 1 level, by at most {d.Largest}.\n" +
                Where(comparison, d, mine),
        };
    }

    private static string Where(PictureComparison comparison, PictureDifference d, string mine)
    {
        var (x, y) = d.WrongMiddle!.Value;
        var area = d.WrongArea!.Value;
        var last = d.Mine.Height - 1;
        return $"  In the middle of the widest wrong area: column {x}, line {y} from the top (row {last - y} from the bottom): " +
            $"{d.Mine[x, y]} instead of {d.Reference[x, y]}.\n" +
            $"  All wrong pixels lie in the columns {area.Left} to {area.Right} and the lines {area.Top} to {area.Bottom} from the top " +
            $"(rows {last - area.Bottom} to {last - area.Top}).\n" +
            (d.OffByOne > 0 ? $"  Besides, {OffByOne(d)}.\n{(d.OffByOne > d.Pixels / 10 ? Indented(Rounding(d)) : "")}" : "") +
            OneColor(comparison, mine) + Observed(comparison) +
            (comparison.ByModels is { } models ? ModelsText.Format(comparison, models, mine) : "");
    }

    private static string OneColor(PictureComparison comparison, string mine) =>
        comparison.Mine.IsNearlyOneColor
            ? $"{mine} is all {comparison.Mine.OneColorInWords}: very many mistakes make such a picture, so it proves nothing.\n" : "";

    /// <summary>What is certain; of a picture of one colour that is that it proves nothing.</summary>
    private static string Observed(PictureComparison comparison) => comparison.Mine.IsNearlyOneColor ? ""
        : string.Concat(comparison.Observations.Sentences.Select(sentence => sentence + "\n"));

    /// <summary>What more pixels are than rounding explains, and why.</summary>
    internal static string RoundedOtherwise(PictureDifference d) =>
        $"is rounded otherwise: {OffByOne(d)}, but only 1 % may be.\n" + Indented(Rounding(d));

    /// <summary>Why channels are off by a level; null if they are so both ways.</summary>
    private static string? Rounding(PictureDifference d)
    {
        var lighter = d.OffByOne - d.OneDarker;
        return lighter <= 0.01 * d.OffByOne
                ? $"{Digits.Share(d.OneDarker, d.Pixels)} of the pixels are one level darker: truncated instead of rounded? " +
                    "The slide rounds a channel: 255 x + 0.5."
            : d.OneDarker <= 0.01 * d.OffByOne
                ? $"{Digits.Share(lighter, d.Pixels)} of the pixels are one level lighter: rounded up, or times 256 instead of 255?"
            : null;
    }

    private static string Indented(string? sentence) => sentence is null ? "" : $"  {sentence}\n";

    private static string OffByOne(PictureDifference d) =>
        $"{Digits.Part(d.OffByOne, d.Pixels)} {(d.OffByOne == 1 ? "is" : "are")} off by 1 level";

    private static string Outlines(PictureDifference d) =>
        $"{Digits.Part(d.Wrong, d.Pixels)} show{(d.Wrong == 1 ? "s" : "")} the other side of an outline";
}
