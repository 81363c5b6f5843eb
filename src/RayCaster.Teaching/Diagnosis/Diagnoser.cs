namespace RayCaster.Teaching.Diagnosis;

/// <summary>
/// A scene prepared for judging many pictures: what all of them need is drawn once, so a right picture takes some milliseconds. Several threads may
/// judge pictures at the same time.
/// </summary>
/// <remarks>For a single picture <see cref="DiagnosisResult.Find"/> does.</remarks>
public sealed class Diagnoser
{
    /// <summary>How many pixels are drawn with each mistake, at most.</summary>
    private const int Pixels = 6000;

    private readonly Lazy<(IReadOnlyList<Mistake> Hidden, int Tried)> hidden;
    private readonly Lazy<Rendering> rendering; // only a picture with a mistake needs it
    private readonly (int Width, int Height)? size;

    /// <summary>Draws the scene.</summary>
    /// <param name="scene">The scene that the pictures should show, at their size.</param>
    /// <param name="threads">How many threads draw, and judge each picture; one per core if left out.</param>
    /// <param name="possible">Which mistakes are tried, for example those of the code written so far; all if left out.</param>
    /// <param name="budget">How much all searches together may do; any amount if left out.</param>
    /// <param name="size">The size that the scene's picture should have, if the pictures have another.</param>
    public Diagnoser(Scene scene, int? threads = null, Predicate<Change>? possible = null, SearchBudget? budget = null,
        (int Width, int Height)? size = null)
    {
        this.size = size;
        Scene = scene;
        Threads = threads;
        Possible = possible;
        Budget = budget;
        Right = Renderer.Render(scene, threads);
        Known = [.. MistakeCatalog.Visible.Where(mistake => mistake.Touches(scene) && possible?.Invoke(mistake.Usual) != false
            && mistake.Changes.All(change => MutationCoverage.CanTry(scene, change)))];
        rendering = new(() => Rendering.OfPicture(scene, MutationCoverage.MoreSamples, budget));
        hidden = new(() => TooManyModels ? ([], 0) : MutationCoverage.HiddenIn(scene, threads, budget));
    }

    /// <summary>The scene.</summary>
    public Scene Scene { get; }

    /// <summary>Its picture.</summary>
    public Picture Right { get; }

    /// <summary>The mistakes of the catalogue that the scene's picture cannot show. The first use takes longer than a diagnosis.</summary>
    public IReadOnlyList<Mistake> Hidden => hidden.Value.Hidden;

    /// <summary>How many mistakes were tried for <see cref="Hidden"/>: all that change a pixel, unless the work was limited.</summary>
    public int TriedForHidden => hidden.Value.Tried;

    /// <summary>Whether it has too many models for mistakes to be tried.</summary>
    public bool TooManyModels => Scene.Models.Count > MutationCoverage.MaxModels;

    internal int? Threads { get; }

    internal Predicate<Change>? Possible { get; }

    internal SearchBudget? Budget { get; }

    /// <summary>What programs draw of the picture, as <see cref="MutationCoverage"/> judges it.</summary>
    internal Rendering Rendering => rendering.Value;

    /// <summary>The mistakes that can show in this scene at all.</summary>
    public IReadOnlyList<Mistake> Known { get; }

    /// <summary>The scene's picture in the size that it should have, if another picture may be a part of it.</summary>
    internal Picture? Whole(Picture picture) => size is var (width, height) && Crop.IsPossible(picture, width, height)
        ? Renderer.Render(Scene.WithSize(width, height), Threads) : null;

    /// <summary>Whether a picture has the scene's size, or the scene's with width and height swapped, as some mistakes do.</summary>
    public static bool CanJudge(Scene scene, Picture picture) =>
        (picture.Width, picture.Height) == (scene.Camera.Width, scene.Camera.Height)
        || (picture.Height, picture.Width) == (scene.Camera.Width, scene.Camera.Height);

    /// <summary>In how many pixels a picture differs by more than rounding. A few on outlines do not count.</summary>
    public int WrongPixels(Picture picture) => Sample(picture, Pixels).WrongCount;

    /// <summary>Says what is wrong with a picture.</summary>
    /// <param name="picture">The picture; its size is the scene's, or the scene's with width and height swapped.</param>
    /// <param name="done">
    /// What the program certainly does: kinds of shape by their names in scene files, "attenuation", "clipping". Everything else may be missing.
    /// </param>
    /// <param name="likely">Which mistakes are likelier than others, for example those of the code written last; none if left out.</param>
    /// <exception cref="ArgumentException">The picture has another size.</exception>
    public DiagnosisResult Diagnose(Picture picture, IReadOnlyCollection<string>? done = null, Predicate<Change>? likely = null)
    {
        if (!CanJudge(Scene, picture))
            throw new ArgumentException(
                $"a picture of {picture.Width} x {picture.Height} for a scene of {Scene.Camera.Width} x {Scene.Camera.Height}", nameof(picture));
        var diagnosis = new PictureDiagnosis(this, StrictWhereNeeded(picture), new(Known, done ?? [], likely, Possible, Budget, Threads));
        return Whole(picture) is { } whole && Crop.Find(picture, whole) is { } crop
            ? diagnosis.Facts with { Kind = DiagnosisKind.Cropped, CroppedPart = crop.CroppedPart } : diagnosis.Find();
    }

    /// <summary>The pixels by which a picture is judged.</summary>
    internal PictureSample Sample(Picture picture, int pixels, bool forgiveOutlines = true) =>
        new(Scene, Right, picture, pixels, forgiveOutlines && !TooManyModels, Budget);

    /// <summary>The same. If most of the wrong ones lie on outlines, these count too where one mistake explains all of them: a box that loses its
    /// edge to 0 · ∞ is not forgiven.</summary>
    private PictureSample StrictWhereNeeded(Picture picture)
    {
        var sample = Sample(picture, Pixels);
        if (sample.WrongCount >= sample.OutlineCount || sample.OutlineCount <= Coverage.Rendering.LeastPixels) return sample;
        var strict = Sample(picture, Pixels, forgiveOutlines: false);
        return Known.Any(IsAll) ? strict : sample;

        // A mistake of the camera may by chance be the last bits of another program.
        bool IsAll(Mistake mistake) => !mistake.Steps.Any(step => step.IsOfRays()) && mistake.Changes.Any(change => ((double[])[0.1, 1]).All(share =>
            strict.Residual(change.In(FormulaProgram.Slides), share).Unexplained <= Decision.Explained * strict.WrongCount));
    }
}
