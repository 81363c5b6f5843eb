namespace RayCaster.Teaching;

/// <summary>Whether a picture is what it should be, where not, and what was done to it, as far as the two pictures and the scene tell.</summary>
public sealed class PictureComparison
{
    /// <summary>Compares; pictures of different sizes too.</summary>
    /// <param name="mine">The picture in question.</param>
    /// <param name="reference">The one that it should be.</param>
    /// <param name="scene">What the reference shows; its camera's size does not matter. Without it nothing is said of models.</param>
    /// <param name="threads">How many threads cast rays; one per core if left out.</param>
    public PictureComparison(Picture mine, Picture reference, Scene? scene = null, int? threads = null)
    {
        (Mine, Reference, Scene) = (mine, reference, scene);
        if ((mine.Width, mine.Height) == (reference.Width, reference.Height))
        {
            Difference = new(mine, reference);
            if (scene is not null) ByModels = SceneDifference.Find(scene, Difference, threads);
        }
        IOutlines outlines = ByModels is { IsReferenceOwn: true }
            ? new SceneOutlines(SceneDifference.InSizeOf(scene!, reference))
            : PictureOutlines.Instance;
        Likeness = Difference is null ? Likeness.Wrong : Likenesses.Of(Difference, outlines);
        if (Likeness == Likeness.Wrong) Recognition = ChangeFinder.Find(mine, reference, Difference, outlines);
    }

    /// <summary>The picture in question.</summary>
    public Picture Mine { get; }

    /// <summary>The one that it should be.</summary>
    public Picture Reference { get; }

    /// <summary>What the reference shows, if that was given.</summary>
    public Scene? Scene { get; }

    /// <summary>The verdict; pictures of different sizes are <see cref="Likeness.Wrong"/>.</summary>
    public Likeness Likeness { get; }

    /// <summary>Where the pictures differ; null if their sizes do.</summary>
    public PictureDifference? Difference { get; }

    /// <summary>What was done to the whole picture; null where it is not wrong, or nothing known explains it.</summary>
    public Recognition? Recognition { get; }

    /// <summary>The difference model by model; null without a scene, or if the sizes differ.</summary>
    public SceneDifference? ByModels { get; }
}
