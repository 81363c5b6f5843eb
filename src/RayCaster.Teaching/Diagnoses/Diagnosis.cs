namespace RayCaster.Teaching;

/// <summary>
/// Finds out why a picture is wrong: draws some of the scene's pixels as unfinished programs do, with each mistake of the catalogue, and with
/// pairs of them, and chooses the nearest.
/// </summary>
/// <remarks>
/// The picture of another program is never equal to the last bit: a channel may be off by a level, and rays may pass through the pixels'
/// centres instead of their corners. The distance is the number of pixels that differ: small faults and other algebra disturb it less than a
/// mean of differences.
/// </remarks>
public sealed class Diagnosis
{
    /// <summary>In <see cref="NotYet"/>: models do not get darker with the distance.</summary>
    public const string Attenuation = "attenuation";

    /// <summary>In <see cref="NotYet"/>: zNear and zFar have no effect; only what lies behind the camera is left out.</summary>
    public const string Clipping = "clipping";

    /// <summary>What <see cref="NotYet"/> may hold: the kinds of shape as a scene file calls them, then the rest.</summary>
    public static IReadOnlyList<string> Parts { get; } = [.. ShapeKind.All.Select(kind => kind.Name), Attenuation, Clipping];

    /// <summary>How many pixels are drawn with each mistake, at most.</summary>
    private const int Pixels = 6000;

    private readonly SceneDiagnosis prepared;
    private readonly Evidence evidence;
    private readonly Answer answer;

    internal Diagnosis(SceneDiagnosis prepared, Picture picture, IReadOnlyCollection<string> done, Predicate<Mistake>? likely)
    {
        this.prepared = prepared;
        var scene = prepared.Scene;
        var right = prepared.Right;
        evidence = new(scene, right, picture, Pixels, !TooManyModels, prepared.Budget);
        if (evidence.WrongCount < evidence.OutlineCount && evidence.OutlineCount > SceneFitness.LeastPixels)
        {
            var strict = new Evidence(scene, right, picture, Pixels, forgiveOutlines: false, prepared.Budget);
            if (prepared.Known.Any(mistake => IsAll(mistake, strict))) evidence = strict;
        }
        if (prepared.Whole(picture) is { } whole && Crop.Find(picture, whole) is { } crop)
        {
            answer = new(Finding.Cropped);
            Missing = crop.Missing;
            return;
        }
        if (WrongCount == 0 || (TooManyModels && evidence.IsOnlyOutlines))
        {
            answer = new(Finding.Matches);
            return;
        }
        var plain = PlainPicture.Describe(scene, picture, right);
        var tellsNothing = new Answer(Finding.TellsNothing) { Likely = plain is null ? [] : [plain] };
        if (plain is not null && (TooManyModels || !PlainPicture.IsOneShade(scene, picture)))
        {
            answer = tellsNothing;
            return;
        }
        answer = new(Finding.NoneOfThese);
        if (TooManyModels) return;

        var byModels = evidence.HasRightSize ? new SceneDifference(scene, new(picture, right), prepared.Threads) : null;
        Misfit? leftByMissingModel = null;
        if (byModels?.MissingModel is { } missing)
        {
            MissingModel = ModelName.Of(scene, missing);
            leftByMissingModel = evidence.Misfit(
                scene with { Models = [.. scene.Models.Where((_, i) => i != missing)] }, FormulaProgram.For(scene.Camera));
        }
        answer = new Judgement(prepared, evidence, done, likely, byModels, leftByMissingModel).Decide();
        evidence.Forget(); // a diagnosis is often kept
        if (plain is null) return;
        // several mistakes, or one of thousands of edits, would explain one colour by chance
        answer = answer with
        {
            Suspects = [.. Suspects.Where(suspect => suspect is { Mistakes: [{ Id: not EditNaming.Id }], NotYet.Count: 0 })],
        };
        if (Suspects.Count == 0) answer = tellsNothing;
    }

    /// <summary>Whether the scene has too many models for its mistakes to be tried.</summary>
    public bool TooManyModels => prepared.TooManyModels;

    /// <summary>Mistakes that would take too long to try, because the scene has too many triangles.</summary>
    public IReadOnlyList<Mistake> NotTried => prepared.NotTried;

    /// <summary>
    /// What the program does not do yet, as far as the picture shows: kinds of shape by their names in scene files, "attenuation", "clipping". With
    /// <see cref="Finding.Unfinished"/> everything else is right; otherwise there are also mistakes.
    /// </summary>
    public IReadOnlyList<string> NotYet => answer.NotYet;

    /// <summary>The kind of difference, if no mistake explains it: sentences, the most informative first.</summary>
    public IReadOnlyList<string> Likely => answer.Likely;

    /// <summary>The name of the model without which the scene gives the picture; null if there is none.</summary>
    public string? MissingModel { get; }

    /// <summary>The lines and columns without which the scene's picture is this one, with <see cref="Finding.Cropped"/>; otherwise null.</summary>
    public string? Missing { get; }

    /// <inheritdoc cref="PictureDifference.Shift"/>
    public int? Shift => evidence.Shift;

    /// <summary>Whether the scene's own picture is of one colour, so that a picture that matches proves nothing.</summary>
    public bool ProvesNothing => prepared.Right.IsOneColor;

    /// <summary>The result.</summary>
    public Finding Finding => answer.Finding;

    /// <summary>Which mistakes may have made the picture, the most likely first.</summary>
    public IReadOnlyList<Suspect> Suspects => answer.Suspects;

    /// <summary>If nothing explains the picture, the nearest mistakes, the one that explains most first.</summary>
    public IReadOnlyList<Suspect> Nearest => answer.Nearest;

    /// <summary>How many pixels the picture has.</summary>
    public int PixelCount => evidence.PixelCount;

    /// <summary>In how many pixels it differs from the scene's picture by more than rounding.</summary>
    public int WrongCount => evidence.WrongCount;

    /// <summary>In how many pixels more it shows what the scene shows a thousandth of a pixel away, where the last bits decide.</summary>
    public int OutlineCount => evidence.OutlineCount;

    /// <summary>The share of pixels that are right but for a channel that is one level darker: rounding instead of truncating.</summary>
    public double DarkerShare => evidence.DarkerShare;

    /// <summary>Diagnoses a picture; for many of one scene see <see cref="SceneDiagnosis"/>.</summary>
    /// <param name="scene">The scene that it should show, at the picture's size.</param>
    /// <param name="picture">The picture; its size is the scene's, or the scene's with width and height swapped.</param>
    /// <param name="budget">How much may be done; any amount if left out.</param>
    /// <exception cref="ArgumentException">The picture has another size.</exception>
    public static Diagnosis Of(Scene scene, Picture picture, SearchBudget? budget = null) =>
        new SceneDiagnosis(scene, budget: budget).Judge(picture);

    /// <summary>
    /// Whether a mistake is all that is wrong, outlines too: a box that loses its edge to 0 · ∞ is not forgiven. A mistake of the camera may by
    /// chance be the last bits of another program.
    /// </summary>
    private bool IsAll(Mistake mistake, Evidence strict) => (mistake.Affects & Affects.Camera) == 0
        && mistake.Variants.Any(variant => ((double[])[0.1, 1]).All(share =>
            strict.Misfit(variant.In(FormulaProgram.For(prepared.Scene.Camera)), share).Unexplained <= Judgement.Explained * strict.WrongCount));
}
