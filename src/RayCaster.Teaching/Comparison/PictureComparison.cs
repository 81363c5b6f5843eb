namespace RayCaster.Teaching.Comparison;

/// <summary>Compares a picture with the one that it should be: whether it is right, where it is wrong, and which change explains that.</summary>
public sealed class PictureComparison
{
    private readonly PictureJudge judge;

    /// <summary>Compares two pictures, which may have different sizes.</summary>
    /// <param name="scene">The reference's scene, in any size; without it, models are not compared.</param>
    /// <param name="threads">How many threads cast rays; one per core if left out.</param>
    public PictureComparison(Picture mine, Picture reference, Scene? scene = null, int? threads = null)
        : this(mine, reference, scene, null, threads)
    {
    }

    /// <param name="hits">What the scene's rays hit, if they are cast already.</param>
    private PictureComparison(Picture mine, Picture reference, Scene? scene, HitMap? hits, int? threads)
    {
        (Mine, Reference) = (mine, reference);
        if (scene is not null) Scene = scene.WithSize(reference.Width, reference.Height);
        if ((mine.Width, mine.Height) == (reference.Width, reference.Height))
        {
            Difference = new(mine, reference);
            if (Scene is not null) ByModels = new(Scene, Difference, threads, hits);
        }
        else Crop = Crop.Find(mine, reference);
        judge = new(reference, ByModels is { IsReferenceOwn: true } ? Scene : null);
        Likeness = Difference is null ? Likeness.Wrong : judge.Compare(Difference);
    }

    /// <summary>Compares with a scene's own picture. Its rays are cast once, for the picture and for the models that it shows.</summary>
    public static PictureComparison With(Scene scene, Picture mine)
    {
        var hits = new Renderer(scene).CastHits();
        return new(mine, scene.PictureOf(hits), scene, hits, null);
    }

    /// <summary>The picture in question.</summary>
    public Picture Mine { get; }

    /// <summary>The one that it should be.</summary>
    public Picture Reference { get; }

    /// <summary>The reference's scene in its size; null if it was not given.</summary>
    internal Scene? Scene { get; }

    /// <summary>The verdict; pictures of different sizes are <see cref="Likeness.Wrong"/>.</summary>
    public Likeness Likeness { get; }

    /// <summary>Where the pictures differ; null if their sizes do.</summary>
    public PictureDifference? Difference { get; }

    /// <summary>What the picture lacks at its border, if it is right but for that.</summary>
    internal Crop? Crop { get; }

    /// <summary>What a wrong picture shows; found when it is first asked for.</summary>
    internal Observations Observations => field ??= new(Mine, Reference, Difference, ByModels is { IsReferenceOwn: true } ? ByModels : null,
        ByModels is { IsReferenceOwn: true } ? Scene : null, judge);

    /// <summary>The difference model by model; null without a scene, or if the sizes differ.</summary>
    internal SceneDifference? ByModels { get; }
}
