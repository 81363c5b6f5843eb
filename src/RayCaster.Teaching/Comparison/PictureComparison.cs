namespace RayCaster.Teaching.Comparison;

/// <summary>Compares a picture with the one that it should be: whether it is right, where it is wrong, and which change explains that.</summary>
public sealed class PictureComparison
{
    /// <summary>Compares two pictures, which may have different sizes.</summary>
    /// <param name="scene">The reference's scene, in any size; without it, models are not compared.</param>
    /// <param name="threads">How many threads cast rays; one per core if left out.</param>
    public PictureComparison(Picture mine, Picture reference, Scene? scene = null, int? threads = null)
    {
        (Mine, Reference) = (mine, reference);
        if (scene is not null) Scene = scene.WithSize(reference.Width, reference.Height);
        if ((mine.Width, mine.Height) == (reference.Width, reference.Height))
        {
            Difference = new(mine, reference);
            if (Scene is not null) ByModels = new(Scene, Difference, threads);
        }
        else Crop = Crop.Find(mine, reference);
        var judge = new PictureJudge(reference, ByModels is { IsReferenceOwn: true } ? Scene : null);
        Likeness = Difference is null ? Likeness.Wrong : judge.Judge(Difference);
        if (Likeness != Likeness.Wrong) return;
        if (Difference is not null)
        {
            FewColors = Comparison.FewColors.Find(Difference);
            if (FewColors is null) Unreached = UnreachedPixels.Find(Difference, Scene);
        }
        if (FewColors is null && Unreached is not { IsRestRight: true })
            Recognition = new TransformFinder(mine, reference, Difference, judge).Find();
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

    /// <summary>A change of the whole picture that explains the difference; null if there is none.</summary>
    internal Recognition? Recognition { get; }

    /// <summary>What the picture lacks at its border, if it is right but for that.</summary>
    internal Crop? Crop { get; }

    /// <summary>The pixels that no loop reached; null if there are none.</summary>
    internal UnreachedPixels? Unreached { get; }

    /// <summary>A sentence if the picture is right but for the number of its colours; otherwise null.</summary>
    internal string? FewColors { get; }

    /// <summary>The difference model by model; null without a scene, or if the sizes differ.</summary>
    internal SceneDifference? ByModels { get; }
}
