namespace RayCaster.Teaching.Comparison;

/// <summary>
/// What a wrong picture shows before a formula is tried, for every command. Of values, places and models, what explains all of it has a price, and
/// the cheapest counts. Where nothing explains it, one ordered table says what is certain: <see cref="Table"/>.
/// </summary>
internal sealed class Observations
{
    /// <summary>A picture has a colour of its own in at least this share of its pixels, or hardly in any.</summary>
    private const double Enough = 0.05, Hardly = 0.005;

    /// <summary>The shares of the wrong pixels: nearly all; most.</summary>
    private const double NearlyAll = 0.97, Most = 0.5;

    /// <summary>The share of the right picture's edges that a picture of the same outlines has.</summary>
    private const double SameEdges = 0.9;

    /// <summary>By how many levels neighbours differ on one model, and by how many at a new edge.</summary>
    private const int Smooth = 8, Edge = 40;

    private const string OtherOutlines =
        "The outlines are others: look at the camera (P, T, up), at h and w, uc and ur, at which hit is the nearest, " +
        "and at the order of the pixels.";

    private readonly Scene? scene;
    private readonly PictureJudge judge;
    private readonly PictureDifference? difference;
    private readonly ColorMap? colors;
    private readonly Lazy<Explanation?> best;
    private readonly Lazy<string?> plain;
    private readonly Lazy<double> strangeShare; // of the pixels, whose colour no model has

    /// <param name="difference">That of the picture to the right one; null if the sizes differ.</param>
    /// <param name="byModels">The difference model by model; null if the scene is not known, or if the right picture is not its own.</param>
    /// <param name="scene">The scene in the right picture's size; null if it is not known.</param>
    public Observations(Picture mine, Picture right, PictureDifference? difference, SceneDifference? byModels, Scene? scene, PictureJudge judge)
    {
        (Mine, Right, this.difference, ByModels, this.scene, this.judge) = (mine, right, difference, byModels, scene, judge);
        colors = scene is null ? null : new(scene);
        (best, plain) = (new(FindBest), new(FindPlain));
        strangeShare = new(() => colors is null ? 0 : Share(Mine, shown => colors.ModelOf(shown) == ColorMap.Strange));
    }

    private Picture Mine { get; }

    private Picture Right { get; }

    /// <summary>The difference model by model; null if there is none.</summary>
    public SceneDifference? ByModels { get; }

    /// <summary>The cheapest explanation by values, places or models, if it is shorter than some other program; otherwise null.</summary>
    public Explanation? Best => best.Value;

    /// <summary>The names of the models that are missing, if that is the cheapest explanation; otherwise null.</summary>
    public string? MissingModels => Best?.Way == Way.Models && ByModels!.MissingModels is { Count: > 0 } missing
        ? string.Join(", ", missing.Select(model => ModelName.Format(scene!, model))) : null;

    /// <summary>Whether what is certain proves that the picture is of this scene.</summary>
    public bool IsOfScene => ByModels?.FaultLocalization.IsCertain == true || Best is not null;

    /// <summary>What such a picture shows that shows very little, and where to look; null if it shows more, or the right one shows as
    /// little.</summary>
    public string? Plain => plain.Value;

    /// <summary>Whether every pixel has the same colour but for a level or two, and neither black nor the background's.</summary>
    public bool IsOneShade => Mine.IsNearlyOneColor && IsColored(Mine.At(Mine.Count / 2));

    /// <summary>In how many wrong pixels each kind of shape and the background shows, if nearly all show what they should in another
    /// light.</summary>
    public IReadOnlyDictionary<string, int> OtherLight => field ??= FindOtherLight();

    /// <summary>What is said of the picture where no formula explains it: that it shows very little, the cheapest explanation, or what is
    /// certain of the rest.</summary>
    public IReadOnlyList<string> Sentences => field ??= Plain is { } plain ? [plain] : Best is { } shortest ? [shortest.Sentence]
        : Table().Where(row => row.Holds()).Select(row => row.Say().ToArray()).FirstOrDefault(said => said.Length > 0) ?? [];

    /// <summary>Each sentence with its condition; the first that holds is said.</summary>
    private IEnumerable<(Func<bool> Holds, Func<IEnumerable<string>> Say)> Table() =>
    [
        (() => LightInWords is not null, () => [LightInWords!]),
        (() => ByModels is not null && (IsCertain || ModelsText.Reported(ByModels) is [_]
            || ModelsText.Reported(ByModels).All(model => model.IsExplained)),
            () => ModelsText.Sentences(scene!, ByModels!)),
        (() => strangeShare.Value > Most, () => [string.Create(CultureInfo.InvariantCulture,
            $"This is another picture, or its colours were changed: {100 * strangeShare.Value:0} % of its pixels have a colour " +
            $"that no model of the scene has in any light.")]),
        (() => IsWrongOnlyOnOutlines, () =>
            ["Only outlines are wrong: look at where in its pixel a ray passes. Was the picture scaled or smoothed on its way?"]),
        (() => scene is not null && strangeShare.Value <= 0.1
            && (difference is null || difference.Wrong >= difference.Pixels / 3 && !HasItsEdges), () =>
            [$"Its colours are those of the scene. {OtherOutlines}"]),
    ];

    private bool IsCertain => ByModels?.FaultLocalization.IsCertain == true;

    private string[] KindsOfWrong => field ??= ByModels is null ? [] :
        [.. ModelsText.Reported(ByModels).Where(model => model.Model >= 0).Select(model => scene!.Models[model.Model].Kind).Distinct()];

    /// <summary>What is said if nearly all wrong pixels show what they should in another light; null if that is not so, or not of all.</summary>
    private string? LightInWords => OtherLight.Count == 0 || ByModels!.LostPixels is not null || IsCertain && KindsOfWrong.Length != 1 ? null
        : ModelsText.Reported(ByModels) is [var only] ? $"Only {only.Name}: the same outline, but another light. Is its t right?"
        : KindsOfWrong is [var kind] && scene!.Models.Any(model => model.Kind != kind)
            ? $"Only {MissingPart.Many(kind)}: the same outlines, but another light. Is their t right?"
        : IsCertain ? null : "All outlines are right, only the light is not: look at the attenuation, and at the way from a colour to its bytes.";

    private Explanation? FindBest()
    {
        double wrong = difference?.Wrong ?? Mine.Count;
        List<Explanation?> found = [PlaceMap.Find(Mine, Right, judge, difference?.Wrong)];
        if (difference is not null) found.Add(UnreachedLinesFinder.Explain(difference, judge));
        // A shape that uncovers what lies behind it changes its own colours into others, too: values that no other shape has.
        if (difference is not null && ByModels?.FaultLocalization.Kinds.Count is not > 0)
            found.Add(ValueMap.Find(difference, isOfMostValues: ByModels is null));
        if (ByModels is not null)
        {
            found.Add(ByModels.LostPixels?.Explanation);
            if (ByModels.MissingModels.Count > 0) found.Add(ModelsText.Missing(scene!, ByModels));
            else if (ModelsText.Reported(ByModels) is [{ OtherColor: not null }])
                found.Add(new(Way.Models, ModelsText.Sentences(scene!, ByModels).First(), Priors.OtherColor));
        }
        var offByOne = Priors.WeightOf(0, difference?.OffByOne ?? 0); // formulas pay for truncated bytes, too
        return found.OfType<Explanation>().Select(one => one.Way == Way.Places ? one : one with { Unexplained = one.Unexplained + offByOne })
            .Where(one => one.Total(wrong) < Priors.OtherProgram).MinBy(one => one.Total(wrong));
    }

    private string? FindPlain()
    {
        if (Mine.IsNearlyOneColor && (scene is null || IsOneShade || Right.IsNearlyOneColor))
            return $"Every pixel has the same colour, {Mine.OneColorInWords}: do the rays of two pixels differ?";
        if (scene is null || !Mine.IsNearlyOneColor && Share(Right, IsColored) < Enough) return null;
        if (Share(Mine, IsColored) > Hardly)
        {
            return Share(Mine, shown => IsColored(shown) && !IsWhite(shown)) <= Hardly && Share(Right, shown => !IsGrey(shown)) > Hardly
                ? "All that is drawn is white: no model's colour shows. Look at the attenuation, and at the way from a colour to its bytes." : null;
        }
        if (IsBlack(scene.Background.ToBytes()))
            return "The picture is black, and so is the background: either no hit counts, or all light is lost. " +
                "Which hits count, and what is the attenuation?";
        if (Share(Mine, IsBlack) <= Hardly) return "There is nothing but background: no model is hit, or no hit counts.";
        if (Share(Mine, IsBlack) >= 1 - Hardly)
            return "The picture is black, and the background is not: are the bytes written, and in their range from 0 to 255?";
        // Black that is no model's outline is another scene, or another camera.
        return difference is not null && Enumerable.Range(0, Mine.Count).Count(i =>
            IsBlack(Mine.At(i)) != (Right.At(i) != scene.Background.ToBytes()))
            <= Hardly * Mine.Count
            ? "All that is drawn is black: the light is lost. Is the attenuation, or a colour on its way to bytes, cut to an integer or negative?"
            : $"All that is drawn is black. {OtherOutlines}";
    }

    private bool IsColored((byte, byte, byte) shown) =>
        !IsBlack(shown) && (scene is null || !PictureJudge.IsNear(shown, scene.Background.ToBytes()));

    /// <summary>Whether most wrong pixels have a neighbour of another colour in the right picture.</summary>
    private bool IsWrongOnlyOnOutlines => difference is not null && Enumerable.Range(0, difference.Pixels).Where(difference.IsWrong).Count(i =>
        Neighbours(i).Any(other => PictureDifference.Levels(Right.At(other), Right.At(i)) > Smooth)) > Most * difference.Wrong;

    /// <summary>Whether nearly all edges of the right picture are there. Then its outlines are right, whatever lies between them.</summary>
    private bool HasItsEdges
    {
        get
        {
            var edges = from i in Enumerable.Range(0, Right.Count)
                        from other in Neighbours(i)
                        where other < i && PictureDifference.Levels(Right.At(i), Right.At(other)) > Edge
                        select PictureDifference.Levels(Mine.At(i), Mine.At(other)) > Smooth;
            var (all, there) = (0, 0);
            foreach (var isThere in edges) (all, there) = (all + 1, there + (isThere ? 1 : 0));
            return there >= SameEdges * all;
        }
    }

    private IEnumerable<int> Neighbours(int i)
    {
        var (y, x) = Math.DivRem(i, Right.Width);
        if (x > 0) yield return i - 1;
        if (x + 1 < Right.Width) yield return i + 1;
        if (y > 0) yield return i - Right.Width;
        if (y + 1 < Right.Height) yield return i + Right.Width;
    }

    private Dictionary<string, int> FindOtherLight()
    {
        if (ByModels is null || scene is null || difference is null) return [];
        var (edges, count, models) = (0, new Dictionary<string, int>(), ByModels.ModelAt);
        foreach (var i in Enumerable.Range(0, difference.Pixels).Where(difference.IsWrong))
        {
            var (kind, color) = models[i] < 0 ? ("background", scene.Background) : (scene.Models[models[i]].Kind, scene.Models[models[i]].Color);
            if (Shade.IsOf(Mine.At(i), color) || Shade.IsTooBright(Mine.At(i), color)) count[kind] = count.GetValueOrDefault(kind) + 1;
            // Two grey models are shades of each other, and black is a shade of all. Then a new edge within a model shows the difference.
            if (Neighbours(i).Any(other => other < i && models[other] == models[i]
                && PictureDifference.Levels(Right.At(i), Right.At(other)) <= Smooth
                && PictureDifference.Levels(Mine.At(i), Mine.At(other)) > Edge)) edges++;
        }
        // A cut through an area is about as long as its side.
        return count.Values.Sum() >= NearlyAll * difference.Wrong && 4 * edges <= Math.Sqrt(difference.Wrong) ? count : [];
    }

    private static bool IsBlack((byte R, byte G, byte B) shown) => PictureJudge.IsNear(shown, default);

    private static bool IsWhite((byte R, byte G, byte B) shown) => Math.Min(shown.R, Math.Min(shown.G, shown.B)) == byte.MaxValue;

    private static bool IsGrey((byte R, byte G, byte B) shown) =>
        Math.Max(shown.R, Math.Max(shown.G, shown.B)) - Math.Min(shown.R, Math.Min(shown.G, shown.B)) <= PictureJudge.Tolerance;

    private static double Share(Picture picture, Func<(byte, byte, byte), bool> isSo) =>
        (double)Enumerable.Range(0, picture.Count).Count(i => isSo(picture.At(i))) / picture.Count;
}
