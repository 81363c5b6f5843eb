namespace RayCaster.Teaching.Diagnosis;

/// <summary>Why a picture is wrong: what the program does not draw yet, and which mistakes it may have.</summary>
/// <remarks>
/// The picture of another program is never equal to the last bit: a channel may be off by a level, and rays may pass through the pixels'
/// centres instead of their corners. The distance is the number of pixels that differ: small faults and other algebra disturb it less than a
/// mean of differences.
/// </remarks>
public sealed record DiagnosisResult
{
    internal DiagnosisResult()
    {
    }

    /// <summary>The result.</summary>
    public DiagnosisKind Kind { get; internal init; }

    /// <summary>
    /// What the program does not do yet, as far as the picture shows, as <see cref="MissingPart"/> calls it. With
    /// <see cref="DiagnosisKind.Unfinished"/> everything else is right; otherwise there are also mistakes.
    /// </summary>
    public IReadOnlyList<string> MissingParts { get; internal init; } = [];

    /// <summary>The kind of difference, if no mistake explains it: sentences, the most informative first.</summary>
    public IReadOnlyList<string> Likely { get; internal init; } = [];

    /// <summary>Which mistakes may have made the picture, the most likely first.</summary>
    public IReadOnlyList<Suspect> Suspects { get; internal init; } = [];

    /// <summary>If nothing explains the picture, the nearest mistakes, the one that explains most first.</summary>
    public IReadOnlyList<Suspect> Nearest { get; internal init; } = [];

    /// <summary>The names of the models without which the scene gives the picture; null if there are none.</summary>
    public string? MissingModel { get; internal init; }

    /// <summary>The lines and columns without which the scene's picture is this one, with <see cref="DiagnosisKind.Cropped"/>; otherwise null.
    /// </summary>
    public string? CroppedPart { get; internal init; }

    /// <summary>Whether models that agree, or all kinds of shape but one, prove that the picture is of this scene.</summary>
    public bool IsOfScene { get; internal init; }

    /// <summary>Whether a longer search may give another answer: something is left that nothing explains.</summary>
    public bool IsOpen { get; internal init; }

    /// <summary>Whether the scene has too many models for its mistakes to be tried.</summary>
    public bool TooManyModels { get; internal init; }

    /// <summary>Whether the scene's own picture is of one colour, so that a picture that matches proves nothing.</summary>
    public bool ProvesNothing { get; internal init; }

    /// <summary>In words, that more pixels are off by a level than rounding explains; null if not.</summary>
    public string? Rounding { get; internal init; }

    /// <summary>How many pixels the picture has.</summary>
    public int PixelCount { get; internal init; }

    /// <summary>In how many pixels it differs from the scene's picture by more than rounding.</summary>
    public int WrongCount { get; internal init; }

    /// <summary>In how many pixels more it shows what the scene shows a thousandth of a pixel away, where the last bits decide.</summary>
    public int OutlineCount { get; internal init; }

    /// <summary>Diagnoses a picture; for many of one scene see <see cref="Diagnoser"/>.</summary>
    /// <param name="scene">The scene that it should show, at the picture's size.</param>
    /// <param name="picture">The picture; its size is the scene's, or the scene's with width and height swapped.</param>
    /// <param name="budget">How much may be done; any amount if left out.</param>
    /// <exception cref="ArgumentException">The picture has another size.</exception>
    public static DiagnosisResult Find(Scene scene, Picture picture, SearchBudget? budget = null) =>
        new Diagnoser(scene, budget: budget).Diagnose(picture);
}
