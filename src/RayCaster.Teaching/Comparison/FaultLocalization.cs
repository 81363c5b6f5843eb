namespace RayCaster.Teaching.Comparison;

/// <summary>
/// Which kinds of shape are wrong by themselves in a picture, and which models prove that the rays are right. A kind is wrong by itself if each
/// wrong pixel shows what lies behind it, or its colour in a light that covers what lies behind: then everything else may be right.
/// </summary>
internal sealed class FaultLocalization
{
    /// <summary>The share of the wrong pixels that may be otherwise: pixels on outlines are uncertain.</summary>
    private const double Uncertain = 0.01;

    /// <summary>As many pixels of its own show that a model is drawn at a place.</summary>
    public const int LeastShown = 3;

    /// <summary>How many pixels prove that a model agrees, and how many of these must tell the picture from a mirrored or turned one.</summary>
    private const int LeastAgreeing = 20, LeastTurned = 8;

    /// <summary>How many models are mentioned.</summary>
    private const int MaxNames = 3;

    private readonly Scene scene;
    private readonly HitMap hits;
    private readonly PictureDifference difference;
    private readonly int? threads;
    private readonly ColorMap colors;
    private readonly int[] wrong;
    private readonly int[] rightOf, wrongOf; // how many pixels of each model are right, and wrong

    /// <param name="hits">What the rays hit in the scene.</param>
    /// <param name="difference">That of the picture to the scene's own.</param>
    public FaultLocalization(Scene scene, HitMap hits, PictureDifference difference, int? threads)
    {
        (this.scene, this.hits, this.difference, this.threads) = (scene, hits, difference, threads);
        colors = new(scene);
        wrong = [.. Enumerable.Range(0, difference.Pixels).Where(difference.IsWrong)];
        (rightOf, wrongOf) = (new int[scene.Models.Count], new int[scene.Models.Count]);
        for (var i = 0; i < difference.Pixels; i++)
            if (hits.Model[i] is >= 0 and var model) (difference.IsWrong(i) ? wrongOf : rightOf)[model]++;
        string[] all = [.. scene.Models.Select(model => model.Kind).Distinct()];
        if (wrong.Length == 0) return;
        Kinds = Only(all.Select(kind => (string[])[kind]));
        if (all.Length == 1) // only models that agree prove anything
        {
            Agreeing = ProofWithout([]);
            if (Kinds.Count > 0 && Agreeing.Count > 0) Agreeing = [];
            else Kinds = [];
            return;
        }
        Agreeing = ProofWithout(Kinds);
        if (Kinds.Count > 0 || Agreeing.Count == 0) return;
        string[] suspected = [.. all.Where(kind => !Agreeing.Any(model => scene.Models[model].Kind == kind))];
        Kinds = Only(suspected.SelectMany((one, i) => suspected.Skip(i + 1).Select(other => (string[])[one, other]))
            .Where(pair => pair.Length < all.Length));
    }

    /// <summary>The kinds, as scene files call them; empty if it is not certain which ones they are.</summary>
    public IReadOnlyList<string> Kinds { get; } = [];

    /// <summary>The models that agree and prove that the rays are right; empty if nothing proves it.</summary>
    public IReadOnlyList<int> Agreeing { get; } = [];

    /// <summary>Whether something is certain, so that the picture is of this scene.</summary>
    public bool IsCertain => Kinds.Count + Agreeing.Count > 0;

    /// <summary>What is certain, in words; null if nothing is.</summary>
    public string? Sentence
    {
        get
        {
            if (!IsCertain) return null;
            var right = Agreeing.Count == 0 ? "" : $"The rays are right: {Names(Agreeing)} agree{(Agreeing.Count == 1 ? "s" : "")}. ";
            if (Kinds.Count == 0) return right.TrimEnd();
            var many = string.Join(" and ", Kinds.Select(MissingPart.Many));
            var formula = Kinds.Count == 1 ? "their formula" : "their formulas, and at what these share";
            int[] bad = [.. ModelsOf(Kinds).Where(IsBad)], good = [.. ModelsOf(Kinds).Where(AgreesWholly)];
            var what = good.Length > 0 && bad.Length > 0
                ? $"Of the {many}, only {Names(bad)} {(bad.Length == 1 ? "is" : "are")} wrong: look at the numbers, and at {formula}."
                : right == "" ? $"Only {many} are wrong: look at {formula}."
                : $"{char.ToUpperInvariant(many[0])}{many[1..]} do not: look at {formula}.";
            int[] elsewhere = [.. bad.Where(ShowsElsewhere)];
            return right + what + (elsewhere.Length == 0 ? ""
                : $" {Names(elsewhere)} {(elsewhere.Length == 1 ? "shows" : "show")} where {(elsewhere.Length == 1 ? "it" : "they")} should not.");
        }
    }

    /// <summary>Whether a model is of one of the kinds.</summary>
    public bool Has(int model) => model >= 0 && Kinds.Contains(scene.Models[model].Kind);

    /// <summary>Whether bytes are the colour of a model of one of the kinds.</summary>
    public bool ShowsColor((byte, byte, byte) shown) => ModelsOf(Kinds).Any(model => Shade.IsOf(shown, scene.Models[model].Color));

    /// <summary>The one set of kinds that may be wrong alone; none if several may.</summary>
    private IReadOnlyList<string> Only(IEnumerable<string[]> sets)
    {
        string[][] possible = [.. sets.Where(MayBeOnly).Take(2)];
        return possible is [var only] ? only : [];
    }

    /// <summary>Whether all else may be right.</summary>
    private bool MayBeOnly(string[] kinds)
    {
        var rest = scene with { Models = [.. scene.Models.Where(model => !kinds.Contains(model.Kind))] };
        var behind = new Renderer(rest, threads).CastHits();
        Color[] colors = [.. ModelsOf(kinds).Select(model => scene.Models[model].Color).Distinct()];
        var otherwise = 0;
        var most = Uncertain * wrong.Length;
        foreach (var i in wrong)
        {
            var shown = difference.Mine.At(i);
            if (!PictureJudge.IsNear(shown, rest.BytesAt(behind, i)) && !colors.Any(color => Covers(shown, color, LightBehind(i)))
                && ++otherwise > most) return false;
        }
        return true;

        double LightBehind(int i) => behind.Model[i] < 0 ? 0 : scene.Attenuation<Scalar>(behind.T[i]);
    }

    /// <summary>Whether a pixel shows a colour that lies before something in a light: what is nearer is brighter. A black model is as black in any
    /// light, and so are pixels that nothing was written to: it proves nothing.</summary>
    private static bool Covers((byte, byte, byte) shown, Color color, double lightBehind) =>
        Shade.IsOf(shown, color) ? Shade.MostLightOf(shown, color) >= lightBehind : Shade.IsTooBright(shown, color);

    /// <summary>
    /// The models of other kinds that agree, if they prove that the rays are right: other rays would change them. A plane looks the same from
    /// beside, so planes prove it only together with another shape.
    /// </summary>
    private IReadOnlyList<int> ProofWithout(IReadOnlyCollection<string> kinds)
    {
        int[] models =
        [
            .. Enumerable.Range(0, scene.Models.Count).Where(model => !kinds.Contains(scene.Models[model].Kind)
                && (kinds.Count > 0 ? rightOf[model] >= LeastAgreeing : AgreesWholly(model))),
        ];
        if (models.All(model => scene.Models[model] is Model<Plane>)) return [];
        var right = difference.Reference;
        int[] pixels = [.. Enumerable.Range(0, difference.Pixels).Where(i => !difference.IsWrong(i) && models.Contains(hits.Model[i]))];
        return IsOther((x, y) => right[right.Width - 1 - x, y]) && IsOther((x, y) => right[x, right.Height - 1 - y])
            && IsOther((x, y) => right[right.Width - 1 - x, right.Height - 1 - y])
            ? [.. models.OrderBy(model => !AgreesWholly(model)).ThenBy(model => scene.Models[model] is Model<Plane>)
                .ThenByDescending(model => rightOf[model])]
            : [];

        bool IsOther(Func<int, int, (byte, byte, byte)> turned) =>
            pixels.Where(i => !PictureJudge.IsNear(right.At(i), turned(i % right.Width, i / right.Width))).Skip(LeastTurned - 1).Any();
    }

    private bool AgreesWholly(int model) => rightOf[model] >= LeastAgreeing && wrongOf[model] == 0;

    private bool IsBad(int model) => wrongOf[model] > 0 || ShowsElsewhere(model);

    /// <summary>Whether wrong pixels that should show something else show a model's colour, which no other model has, where the model alone would
    /// not show it: there it lies behind one that is missing.</summary>
    public bool ShowsElsewhere(int model)
    {
        int[] places = [.. wrong.Where(i => hits.Model[i] != model && colors.ModelOf(difference.Mine.At(i)) == model)];
        if (places.Length < LeastShown) return false;
        var alone = scene with { Models = [scene.Models[model]] };
        var own = new Renderer(alone, threads).CastHits();
        return places.Count(i => own.Model[i] < 0 || !PictureJudge.IsNear(difference.Mine.At(i), alone.BytesAt(own, i))) >= LeastShown;
    }

    private IEnumerable<int> ModelsOf(IReadOnlyCollection<string> kinds) =>
        Enumerable.Range(0, scene.Models.Count).Where(model => kinds.Contains(scene.Models[model].Kind));

    private string Names(IReadOnlyList<int> models)
    {
        string[] names = [.. models.Take(MaxNames).Select(model => ModelName.Format(scene, model))];
        return models.Count > MaxNames ? $"{string.Join(", ", names)} and others"
            : names is [.. var first, var last] && first.Length > 0 ? $"{string.Join(", ", first)} and {last}" : names[0];
    }
}
