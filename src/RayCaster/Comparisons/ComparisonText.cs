using System.Globalization;
using System.Text;

namespace RayCaster;

/// <summary>A comparison in words.</summary>
public static class ComparisonText
{
    private const int MostSentences = 6, MostRows = 20;

    /// <summary>The verdict in a word or two.</summary>
    public static string Of(Verdict verdict) => verdict switch
    {
        Verdict.Identical => "identical",
        Verdict.WithinRounding => "within rounding",
        Verdict.OutlinesOnly => "outlines only",
        Verdict.RoundedOtherwise => "rounded otherwise",
        _ => "wrong",
    };

    /// <summary>All that is to be said, in whole lines.</summary>
    /// <param name="comparison">The comparison.</param>
    /// <param name="mine">What the picture in question is called.</param>
    /// <param name="reference">What the one that it should be is called.</param>
    public static string Of(PictureComparison comparison, string mine, string reference)
    {
        var text = new StringBuilder();
        if (comparison.Difference is not { } d)
        {
            var (a, b) = (comparison.Mine, comparison.Reference);
            text.Append($"{mine} is wrong: it has {a.Width} x {a.Height} pixels, {reference} has {b.Width} x {b.Height}");
            text.Append((a.Width, a.Height) == (b.Height, b.Width) ? ": width and height are swapped.\n" : ".\n");
            AppendOneColor(text, comparison, mine);
            AppendRecognition(text, comparison);
            return text.ToString();
        }

        text.Append(comparison.Verdict switch
        {
            Verdict.Identical => $"{mine} and {reference} are identical: {Count(d.Pixels, "pixel")}.\n",
            Verdict.WithinRounding => $"{mine} is right within rounding: {OffByOne(d)}, which is allowed in 1 % of them.\n",
            Verdict.OutlinesOnly => $"{mine} is right but for outlines: {Outlines(d)}, which is allowed.\n",
            Verdict.RoundedOtherwise => $"{mine} is rounded otherwise: {OffByOne(d)}, but it is allowed in 1 % of them only.\n",
            _ => $"{mine} is wrong: {Part(d.Wrong, d.Pixels)} differ by more than 1 level, by at most {d.Largest}.\n",
        });
        if (comparison.Verdict == Verdict.OutlinesOnly && d.OffByOne > 0) text.Append($"  Besides, {OffByOne(d)}.\n");
        if (comparison.Verdict == Verdict.RoundedOtherwise)
        {
            text.Append(Rounding(d));
            if (d.Wrong > 0) text.Append($"  Besides, {Outlines(d)}, which is allowed.\n");
        }
        if (comparison.Verdict == Verdict.Wrong) AppendPlaces(text, comparison, d, mine);
        return text.ToString();
    }

    /// <summary>The measures in one line.</summary>
    public static string Of(Measures m) => string.Create(CultureInfo.InvariantCulture,
        $"Measures, in levels of 255: maximum {m.Maximum}, MAE {m.MeanAbsoluteError:0.#####}, RMSE {m.RootMeanSquareError:0.#####}; " +
        $"PSNR {(m.Maximum == 0 ? "infinite" : $"{m.PeakSignalToNoiseRatio.ToString("0.####", CultureInfo.InvariantCulture)} dB")}, " +
        $"SSIM {m.StructuralSimilarity:0.######}\n");

    private static void AppendPlaces(StringBuilder text, PictureComparison comparison, PictureDifference d, string mine)
    {
        var ((x, y), area) = (d.FirstWrong!.Value, d.WrongArea!.Value);
        var last = d.Mine.Height - 1;
        text.Append($"  The first: column {x}, line {y} from the top (row {last - y} from the bottom): {d.Mine[x, y]} instead of {d.Reference[x, y]}.\n");
        text.Append($"  All lie in the columns {area.Left} to {area.Right} and the lines {area.Top} to {area.Bottom} from the top " +
            $"(rows {last - area.Bottom} to {last - area.Top}).\n");
        text.Append($"  Red differs in {Number(d.WrongByChannel.R)} of them, green in {Number(d.WrongByChannel.G)}, blue in {Number(d.WrongByChannel.B)}.\n");
        if (d.OffByOne > 0) text.Append($"  Besides, {OffByOne(d)}.\n{(d.OffByOne > d.Pixels / 10 ? Rounding(d) : "")}");
        AppendOneColor(text, comparison, mine);
        AppendRecognition(text, comparison);
        if (comparison.ByModels is { } models) AppendModels(text, comparison, models, mine);
    }

    private static void AppendOneColor(StringBuilder text, PictureComparison comparison, string mine)
    {
        if (comparison.Mine.IsOneColor) text.Append($"Every pixel of {mine} is {comparison.Mine[0, 0]}.\n");
    }

    private static void AppendRecognition(StringBuilder text, PictureComparison comparison)
    {
        if (comparison.Recognition is not { } r) return;
        var when = $"when {r.Change.Description}";
        var d = r.Difference;
        text.Append(r.Verdict switch
        {
            Verdict.Identical => $"It becomes identical {when}.\n",
            Verdict.WithinRounding => $"It becomes right within rounding {when}.\n",
            Verdict.OutlinesOnly => $"It becomes right but for {Count(d.Wrong, "pixel")} on outlines {when}.\n",
            Verdict.RoundedOtherwise => $"It becomes right but for rounding {when}; then {OffByOne(d)}.\n{Rounding(d)}",
            _ => $"It becomes nearly right {when}: then {Part(d.Wrong, d.Pixels)} are wrong.\n",
        });
    }

    private static void AppendModels(StringBuilder text, PictureComparison comparison, SceneDifference scene, string mine)
    {
        if (!scene.IsReferenceOwn)
        {
            var own = scene.ReferenceToOwn;
            text.Append(scene.IsMineOwn
                ? $"The scene's own picture is {mine}, not the reference: are the two swapped?\n"
                : $"The reference is not the picture of this scene, from which {Part(own.Wrong, own.Pixels)} differ; so nothing is said of models.\n");
            return;
        }
        // Where a change of the whole picture explains all, its models are not to blame.
        if (comparison.Recognition is not null || comparison.Mine.IsOneColor) return;
        AppendSentences(text, comparison.Scene!, scene);
        if (scene.ReferenceToOwn.Wrong > 0)
            text.Append($"The reference itself differs from the picture of this scene in {Count(scene.ReferenceToOwn.Wrong, "pixel")}.\n");
        AppendTable(text, scene);
    }

    /// <summary>The models that are wrong somewhere, most wrong first.</summary>
    private static void AppendTable(StringBuilder text, SceneDifference scene)
    {
        var width = 5;
        foreach (var model in scene.Models) width = Math.Max(width, model.Name.Length);
        text.Append($"\n  {"model".PadRight(width)}      pixels       wrong\n");
        var (rows, right) = (0, 0);
        foreach (var model in scene.Models)
            if (model.Wrong == 0) right++;
            else if (rows++ < MostRows)
                text.Append($"  {model.Name.PadRight(width)}  {Number(model.Pixels),10}  {Number(model.Wrong),10}  {Share(model.Wrong, model.Pixels)}\n");
        if (rows > MostRows) text.Append($"  and {rows - MostRows} more\n");
        if (right > 0) text.Append($"  {(right == 1 ? "the other" : $"the {right} others")}: none wrong\n");
        text.Append('\n');
    }

    private static void AppendSentences(StringBuilder text, Scene scene, SceneDifference all)
    {
        var (pixels, unexplained, wrong) = (0, 0, 0);
        foreach (var model in all.Models)
        {
            pixels += model.Pixels;
            if (model.Wrong > 0) wrong++;
            if (!model.IsMissing && model.OtherColor is null) unexplained += model.Wrong;
        }
        if (unexplained > pixels / 2) // what is behind a "missing" model may as well be a picture taken from elsewhere
        {
            text.Append($"No single model explains it: {Part(unexplained, pixels)} are wrong all over the picture.\n");
            return;
        }
        var left = MostSentences;
        foreach (var model in all.Models)
            if (model.Wrong > 0 && (Sentence(scene, model) ?? (wrong == 1 ? $"{PartOf(model)} are wrong" : null)) is { } sentence && left-- > 0)
                text.Append($"{sentence}{(wrong == 1 ? "; all others agree" : "")}.\n");
    }

    /// <summary>What can be said of a model beyond how much of it is wrong; null for nothing.</summary>
    private static string? Sentence(Scene scene, ModelDifference model)
    {
        if (model.IsMissing)
            return model.Shows is [var (other, pixels), ..] && pixels >= 0.99 * model.Wrong
                ? $"{model.Name} is missing: {Share(model.Wrong, model.Pixels)} of its pixels show {ModelName.Of(scene, other)}"
                : $"{model.Name} is missing: its pixels show what lies behind it{Behind(scene, model)}";
        if (model.OtherColor is { } color)
            return color.ToBytes() == default ? $"{model.Name} is black"
                : Factor(color, model.Color) is { } factor
                    ? string.Create(CultureInfo.InvariantCulture, $"{model.Name} is {(factor < 1 ? "darker" : "brighter")}: {factor:0.##} times what it should be")
                    : $"{model.Name} has another colour: {Name(color)} instead of {Name(model.Color)}";
        if (model.Shows is not [var (most, count), ..] || count < 0.5 * model.Wrong) return null;
        return count >= 0.95 * model.Wrong
            ? $"{PartOf(model)} are wrong, they show {ModelName.Of(scene, most)}"
            : $"{PartOf(model)} are wrong, {Share(count, model.Wrong)} of these show {ModelName.Of(scene, most)}";
    }

    private static string PartOf(ModelDifference model) => $"{model.Name}: {Share(model.Wrong, model.Pixels)} of its pixels";

    /// <summary>By what a colour must be multiplied to give another; null if no number does.</summary>
    private static double? Factor(Color to, Color from)
    {
        var (sumTo, sumFrom) = (to.R + to.G + to.B, from.R + from.G + from.B);
        if (sumFrom == 0) return null;
        var factor = sumTo / sumFrom;
        var off = Math.Max(Math.Abs(to.R - factor * from.R), Math.Max(Math.Abs(to.G - factor * from.G), Math.Abs(to.B - factor * from.B)));
        return off < 0.02 * sumTo ? factor : null;
    }

    /// <summary>" (`wall` 70 %, the background 20 %)".</summary>
    private static string Behind(Scene scene, ModelDifference model)
    {
        var parts = new List<string>();
        for (var i = 0; i < Math.Min(3, model.Shows.Count); i++)
            parts.Add($"{ModelName.Of(scene, model.Shows[i].Model)} {Share(model.Shows[i].Pixels, model.Wrong)}");
        return parts.Count == 0 ? "" : $" ({string.Join(", ", parts)})";
    }

    private static string Rounding(PictureDifference d) =>
        d.OneDarker >= 0.99 * d.OffByOne ? $"  {Share(d.OneDarker, d.Pixels)} of the pixels are one level darker: truncated instead of rounded?\n"
        : d.OneDarker <= 0.01 * d.OffByOne ? $"  {Share(d.OffByOne - d.OneDarker, d.Pixels)} of the pixels are one level lighter: rounded up, or times 256 instead of 255?\n"
        : "";

    private static string OffByOne(PictureDifference d) => $"{Part(d.OffByOne, d.Pixels)} {(d.OffByOne == 1 ? "is" : "are")} off by 1 level";

    private static string Outlines(PictureDifference d) => $"{Part(d.Wrong, d.Pixels)} show{(d.Wrong == 1 ? "s" : "")} the other side of an outline";

    private static string Part(int part, int whole) => $"{Number(part)} of {Count(whole, "pixel")} ({Share(part, whole)})";

    private static string Name(Color c) => string.Create(CultureInfo.InvariantCulture, $"({c.R:0.###}, {c.G:0.###}, {c.B:0.###})");

    private static string Count(int number, string what) => $"{Number(number)} {what}{(number == 1 ? "" : "s")}";

    private static string Number(int number) => number.ToString("N0", CultureInfo.InvariantCulture);

    /// <summary>A share in percent; only what is all is "100 %", only what is nothing is "0 %".</summary>
    internal static string Share(int part, int whole)
    {
        if (part == whole) return "100 %";
        var percent = 100.0 * part / whole;
        return percent is > 0 and < 0.01 ? "less than 0.01 %" : $"{Math.Min(percent, 99.99).ToString("0.##", CultureInfo.InvariantCulture)} %";
    }
}
