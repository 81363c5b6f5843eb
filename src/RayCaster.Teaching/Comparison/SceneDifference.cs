namespace RayCaster.Teaching.Comparison;

/// <summary>A wrong picture of a scene, model by model.</summary>
internal sealed class SceneDifference
{
    /// <summary>The most models that are drawn alone, to find which one a wrong pixel shows.</summary>
    private const int MaxTried = 32;

    /// <summary>The most models that are left out one by one, to find whether they are missing.</summary>
    private const int MaxLeftOut = 8;

    /// <summary>The share of a model's pixels that an explanation must cover, and of the wrong pixels; pixels on outlines are uncertain.</summary>
    private const double Nearly = 0.99, Mostly = 0.95;

    private readonly Scene scene;
    private readonly PictureDifference difference;
    private readonly HitMap hits, others; // others: of the scene with fewer models
    private readonly int? threads;
    private readonly Lazy<LostPixels?> lostPixels;

    /// <param name="scene">The scene in the pictures' size.</param>
    /// <param name="threads">How many threads cast rays; one per core if null.</param>
    /// <param name="hits">What the rays hit, if they are cast already.</param>
    public SceneDifference(Scene scene, PictureDifference difference, int? threads, HitMap? hits = null)
    {
        (this.scene, this.difference, this.threads) = (scene, difference, threads);
        this.hits = hits ?? new Renderer(scene, threads).CastHits();
        var own = scene.PictureOf(this.hits);
        ReferenceToOwn = new(difference.Reference, own);
        var mineToOwn = new PictureDifference(difference.Mine, own);
        IsMineOwn = IsOwn(mineToOwn) && mineToOwn.Wrong < ReferenceToOwn.Wrong / 10;
        IsReferenceOwn = IsOwn(ReferenceToOwn) && !IsMineOwn;
        others = new(own.Width, own.Height);
        lostPixels = new(() => LostPixels.Find(difference, scene, this.hits.Model));
    }

    public PictureDifference ReferenceToOwn { get; }

    /// <summary>Whether the reference is the scene's own picture: at most 2 % of its pixels differ by more than rounding.</summary>
    public bool IsReferenceOwn { get; }

    /// <summary>Whether the picture in question is the scene's own picture and the reference is not: they may be swapped.</summary>
    public bool IsMineOwn { get; }

    /// <summary>The models that the scene's picture shows, and the background, most wrong first; empty if the reference is not that
    /// picture.</summary>
    public IReadOnlyList<ModelDifference> Models => field ??= IsReferenceOwn && difference.Wrong > 0 ? FindModels() : [];

    /// <summary>The models without which the scene gives the picture, but for one wrong pixel in twenty; empty if there are none.</summary>
    public IReadOnlyList<int> MissingModels => field ??= FindMissing();

    /// <summary>How many pixels the scene without the missing models leaves wrong.</summary>
    public int WrongWithoutMissing { get; private set; }

    /// <summary>Wrong pixels that lie alone; null if they do not.</summary>
    public LostPixels? LostPixels => lostPixels.Value;

    /// <summary>The model that each pixel shows in the scene's own picture, in reading order; −1 for the background.</summary>
    public IReadOnlyList<int> ModelAt => hits.Model;

    /// <summary>Which kinds of shape are wrong by themselves, and what proves that the rays are right.</summary>
    public FaultLocalization FaultLocalization => field ??= new(scene, hits, difference, threads);

    private ILookup<int, int> PixelsOf => field ??= Enumerable.Range(0, difference.Pixels).ToLookup(i => hits.Model[i]);

    private static bool IsOwn(PictureDifference d) => d.Wrong <= d.Pixels / 50;

    private List<ModelDifference> FindModels()
    {
        List<ModelDifference> models = [.. PixelsOf.Select(CountWrong)];
        models.Sort((a, b) => (-a.Share, -a.Wrong, a.Model).CompareTo((-b.Share, -b.Wrong, b.Model)));

        var shown = Shown(models);
        var leftOut = 0;
        for (var i = 0; i < models.Count && models[i].Wrong > 0; i++)
        {
            var model = models[i] with { Shows = [.. shown[models[i].Model]] };
            if (model is { Model: >= 0, Share: >= Nearly / 2 } && leftOut++ < MaxLeftOut)
                model = model with { IsMissing = IsMissing(model) };
            if (!model.IsMissing && model.Share >= Nearly / 2) model = model with { OtherColor = OtherColor(model) };
            models[i] = model;
        }
        return models;
    }

    private ModelDifference CountWrong(IGrouping<int, int> pixels) =>
        new(pixels.Key, ModelName.Format(scene, pixels.Key), pixels.Count(), pixels.Count(difference.IsWrong))
        {
            Color = pixels.Key < 0 ? scene.Background : scene.Models[pixels.Key].Color,
        };

    /// <summary>What the wrong pixels of each model show, the most frequent first: another model that alone fits, and in how many pixels.</summary>
    private ILookup<int, (int Model, int Pixels)> Shown(List<ModelDifference> models)
    {
        var wrong = Enumerable.Range(0, difference.Pixels).Where(difference.IsWrong).ToArray();
        var fitting = new Dictionary<int, int?>(); // the model that a wrong pixel shows; null where several fit
        var background = scene.Background.ToBytes();
        foreach (var i in wrong)
            if (hits.Model[i] >= 0) Try(i, -1, background);

        foreach (var model in models.Where(model => model.Model >= 0).OrderByDescending(model => model.Pixels).Take(MaxTried))
        {
            var alone = scene with { Models = [scene.Models[model.Model]] };
            new Renderer(alone, threads).CastHits(others);
            foreach (var i in wrong)
                if (others.Model[i] >= 0 && hits.Model[i] != model.Model) Try(i, model.Model, alone.BytesAt(others, i));
        }
        return fitting.Where(fit => fit.Value is not null).CountBy(fit => (Of: hits.Model[fit.Key], Other: fit.Value!.Value))
            .OrderBy(count => (-count.Value, count.Key.Other)).ToLookup(count => count.Key.Of, count => (count.Key.Other, count.Value));

        void Try(int pixel, int model, (byte, byte, byte) color)
        {
            if (Shows(pixel, color)) fitting[pixel] = fitting.ContainsKey(pixel) ? null : model;
        }
    }

    private bool IsMissing(ModelDifference model)
    {
        var without = Without([model.Model]);
        return IsExplained(model, pixel => without.BytesAt(others, pixel)) && !FaultLocalization.ShowsElsewhere(model.Model);
    }

    /// <summary>The scene without some models; others are its hits.</summary>
    private Scene Without(IReadOnlyCollection<int> some)
    {
        var without = scene with { Models = [.. scene.Models.Where((_, i) => !some.Contains(i))] };
        new Renderer(without, threads).CastHits(others);
        return without;
    }

    private int[] FindMissing()
    {
        if (difference.Wrong == 0) return [];
        ModelDifference[] wrong = [.. PixelsOf.Where(pixels => pixels.Key >= 0).Select(CountWrong).Where(model => model.Share >= Nearly / 2)];
        int[] all = [.. wrong.Where(model => model.Share >= Nearly).Select(model => model.Model)];
        return [.. ((int[][])[all, .. wrong.Select(model => (int[])[model.Model])]).Select(AreMissing).FirstOrDefault(some => some.Length > 0, [])];
    }

    /// <summary>Some models, if the scene without them gives the picture, and those behind them that must be missing, too; otherwise none.</summary>
    private int[] AreMissing(int[] some)
    {
        while (some.Length > 0)
        {
            var without = Without(some);
            int[] left = [.. Enumerable.Range(0, difference.Pixels).Where(i => !Shows(i, without.BytesAt(others, i)))];
            WrongWithoutMissing = left.Length;
            int[] kept = [.. Enumerable.Range(0, scene.Models.Count).Except(some)];
            int[] behind = [.. left.Where(i => others.Model[i] >= 0).GroupBy(i => others.Model[i])
                .Where(model => model.Count() >= Nearly * others.Model.Count(other => other == model.Key)).Select(model => kept[model.Key])];
            if (behind.Length == 0)
                return left.Length > (1 - Mostly) * difference.Wrong || some.Any(FaultLocalization.ShowsElsewhere) ? [] : [.. some.Order()];
            some = [.. some, .. behind];
        }
        return [];
    }

    /// <summary>The colour that gives the bytes of the model's pixels if it is multiplied by their attenuation; null if none does.</summary>
    private Color? OtherColor(ModelDifference model)
    {
        var color = new Color(Channel(model, 0), Channel(model, 1), Channel(model, 2));
        return IsExplained(model, pixel => (LightAt(pixel, model.Model) * color).ToBytes()) ? color : null;
    }

    /// <summary>Whether nearly all of a model's pixels have some colours.</summary>
    private bool IsExplained(ModelDifference model, Func<int, (byte, byte, byte)> color) =>
        PixelsOf[model.Model].Count(i => Shows(i, color(i))) >= Nearly * model.Pixels;

    /// <summary>The sum of a channel's bytes divided by the sum of the attenuations; rounding changes it little.</summary>
    private double Channel(ModelDifference model, int channel)
    {
        double bytes = 0, light = 0;
        foreach (var i in PixelsOf[model.Model])
        {
            if (difference.Mine.Rgb[3 * i + channel] == 255) continue;
            bytes += difference.Mine.Rgb[3 * i + channel];
            light += 255 * LightAt(i, model.Model);
        }
        return light > 0 ? bytes / light : 1;
    }

    private double LightAt(int pixel, int model) => model < 0 ? 1 : scene.Attenuation<Scalar>(hits.T[pixel]);

    private bool Shows(int pixel, (byte, byte, byte) color) => PictureJudge.IsNear(difference.Mine.At(pixel), color);
}
