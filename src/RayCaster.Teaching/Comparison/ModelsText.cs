namespace RayCaster.Teaching.Comparison;

/// <summary>A comparison in words, model by model.</summary>
internal static class ModelsText
{
    private const int MaxSentences = 6, MaxRows = 20, MaxNames = 4;

    /// <summary>Which models are wrong and how, or why they cannot be compared.</summary>
    public static string Format(PictureComparison comparison, SceneDifference scene, string mine)
    {
        var own = scene.ReferenceToOwn;
        if (!scene.IsReferenceOwn)
            return scene.IsMineOwn
                ? $"The scene's own picture is {mine}, not the reference: are the two swapped?\n"
                : $"The reference is not the picture of this scene: {Digits.Part(own.Wrong, own.Pixels)} differ. " +
                    "So its models are not compared.\n";
        // Values and places of the whole picture explain the difference, not single models.
        if (comparison.Observations.Best is { Way: not Way.Models } || comparison.Mine.IsNearlyOneColor) return "";
        return (own.Wrong > 0 ? $"The reference itself differs from the picture of this scene in {Digits.Count(own.Wrong, "pixel")}.\n" : "") +
            Table(scene);
    }

    /// <summary>The models that are wrong somewhere, most wrong first.</summary>
    private static string Table(SceneDifference scene)
    {
        var width = scene.Models.Select(model => model.Name.Length).Append(5).Max();
        ModelDifference[] wrong = [.. scene.Models.Where(model => model.Wrong > 0)];
        var rows = wrong.Take(MaxRows).Select(model =>
            $"  {model.Name.PadRight(width)}  {Digits.Number(model.Pixels),10}  {Digits.Number(model.Wrong),10}" +
            $"  {Digits.Share(model.Wrong, model.Pixels)}\n");
        return $"\n  {"model".PadRight(width)}      pixels       wrong\n" + string.Concat(rows) +
            (wrong.Length > MaxRows ? $"  and {wrong.Length - MaxRows} more\n" : "") +
            (wrong.Length < scene.Models.Count ? "  all others: none wrong\n" : "") + "\n";
    }

    /// <summary>What is certain of the kinds of shape, then a sentence for each wrong model.</summary>
    public static IEnumerable<string> Sentences(Scene scene, SceneDifference all)
    {
        var meant = Reported(all);
        if (meant is not [{ IsExplained: true }] && all.FaultLocalization is { Sentence: { } certain } kinds)
        {
            ModelDifference[] wrong = [.. meant.Where(model => kinds.Has(model.Model) && !(model.IsMissing && kinds.ShowsElsewhere(model.Model)))];
            return OfModels(scene, all, wrong).Prepend(certain + (all.LostPixels is null ? ""
                : " They are full of holes: is something compared with ==, or with a limit that rounding passes?"));
        }
        return OfModels(scene, all, meant);
    }

    /// <summary>What explains a picture without some models, which may be all of a kind that are small.</summary>
    public static Explanation Missing(Scene scene, SceneDifference all)
    {
        var models = all.MissingModels;
        var kinds = models.Select(model => scene.Models[model].Kind).Distinct().ToArray();
        var sizes = models.Select(SizeOf).ToArray();
        var areSmall = models.Count > 1 && kinds is [var kind] && all.ModelAt.Distinct()
            .Where(model => model >= 0 && scene.Models[model].Kind == kind && !models.Contains(model))
            .Select(SizeOf).DefaultIfEmpty().Min() > sizes.Max();
        string[] names = [.. models.Take(MaxNames).Select(model => ModelName.Format(scene, model))];
        var words = models is [_] ? Reported(all) is [{ IsMissing: true }] ? OfModels(scene, all, Reported(all)).First()
                : $"{names[0]} is missing: without it the scene gives this picture."
            : $"{string.Join(", ", names)}{(models.Count > MaxNames ? $" and {models.Count - MaxNames} more" : "")} are missing: " +
                "without them the scene gives this picture." +
                (areSmall ? $" All other {MissingPart.Many(kinds[0])} are larger: is there a limit that depends on the size?" : "");
        return new(Way.Models, $"{words} Is it in your scene, and in the list that your program casts rays at?",
            Priors.MissingModel + (models.Count > 1 ? Priors.Several * kinds.Length : 0), all.WrongWithoutMissing);

        double SizeOf(int model) => scene.Models[model].Bounds is { } box ? (box.Max - box.Min).Length : double.PositiveInfinity;
    }

    private static IEnumerable<string> OfModels(Scene scene, SceneDifference all, IReadOnlyList<ModelDifference> meant)
    {
        var edges = all.Models.Sum(model => model.Wrong) - meant.Sum(model => model.Wrong);
        var agree = meant.Count != 1 || Reported(all).Count != 1 ? ""
            : edges == 0 ? "; all others agree" : $"; all others agree, but for {Digits.Count(edges, "pixel")}";
        return meant.Select(model => Sentence(scene, model) ?? (meant.Count == 1 ? $"{PartOf(model)} are wrong" : null))
            .OfType<string>().Take(MaxSentences).Select(sentence => $"{sentence}{agree}.");
    }

    /// <summary>The models to report. A model with only a few wrong pixels beside a wrong model is left out: these are edges or ties.</summary>
    public static IReadOnlyList<ModelDifference> Reported(SceneDifference all)
    {
        var most = all.Models.Select(model => model.Wrong).DefaultIfEmpty().Max();
        return [.. all.Models.Where(model => model.Wrong > 0 && (model.Wrong >= 0.01 * most || model.Wrong >= 0.01 * model.Pixels))];
    }

    /// <summary>How a model is wrong; null if only the number of its wrong pixels is known.</summary>
    private static string? Sentence(Scene scene, ModelDifference model)
    {
        if (model.IsMissing)
            return model.Shows is [var (other, pixels), ..] && pixels >= 0.99 * model.Wrong
                ? $"{model.Name} is missing: {Digits.Share(model.Wrong, model.Pixels)} of its pixels show {ModelName.Format(scene, other)}"
                : $"{model.Name} is missing: its pixels show what lies behind it{Behind(scene, model)}";
        if (model.OtherColor is { } color)
            return color.ToBytes() == default ? $"{model.Name} is black"
                : Factor(color, model.Color) is { } factor
                    ? string.Create(CultureInfo.InvariantCulture,
                        $"{model.Name} is {(factor < 1 ? "darker" : "brighter")}: {factor:0.##} times what it should be")
                    : $"{model.Name} has another colour: {Name(color)} instead of {Name(model.Color)}";
        if (model.Shows is not [var (most, count), ..] || count < 0.5 * model.Wrong) return null;
        return count >= 0.95 * model.Wrong
            ? $"{PartOf(model)} are wrong, they show {ModelName.Format(scene, most)}"
            : $"{PartOf(model)} are wrong, {Digits.Share(count, model.Wrong)} of these show {ModelName.Format(scene, most)}";
    }

    private static string PartOf(ModelDifference model) => $"{model.Name}: {Digits.Share(model.Wrong, model.Pixels)} of its pixels";

    /// <summary>The number by which one colour is multiplied to give the other; null if there is none.</summary>
    private static double? Factor(Color to, Color from)
    {
        var sumTo = to.R + to.G + to.B;
        var sumFrom = from.R + from.G + from.B;
        if (sumFrom == 0) return null;
        var factor = sumTo / sumFrom;
        return IsNear(to.R, from.R) && IsNear(to.G, from.G) && IsNear(to.B, from.B) ? factor : null;

        bool IsNear(double a, double b) => Math.Abs(a - factor * b) < 0.02 * sumTo; // bytes are coarse
    }

    /// <summary>" (`wall` 70 %, the background 20 %)".</summary>
    private static string Behind(Scene scene, ModelDifference model)
    {
        var parts = model.Shows.Take(3).Select(shown => $"{ModelName.Format(scene, shown.Model)} {Digits.Share(shown.Pixels, model.Wrong)}");
        return model.Shows.Count == 0 ? "" : $" ({string.Join(", ", parts)})";
    }

    private static string Name(Color c) => string.Create(CultureInfo.InvariantCulture, $"({c.R:0.###}, {c.G:0.###}, {c.B:0.###})");
}
