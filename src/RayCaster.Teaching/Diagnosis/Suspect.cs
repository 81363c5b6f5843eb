namespace RayCaster.Teaching.Diagnosis;

/// <summary>One mistake, or two at once, that may have made a picture.</summary>
/// <param name="Mistakes">The mistakes, the one that explains more first, each in the way that fits best.</param>
/// <param name="Unexplained">In about how many pixels the picture still differs by more than rounding.</param>
/// <param name="OtherSample">Whether its rays also pass through another sample point of each pixel than the scene says: centres for corners.</param>
/// <param name="Twins">Mistakes that draw the same picture of this scene.</param>
/// <param name="MissingParts">What is also not drawn yet, as in <see cref="DiagnosisResult.MissingParts"/>.</param>
/// <param name="SamePicture">Whether it draws the same picture of this scene as the first suspect; true of that one, too.</param>
/// <param name="AsLikely">Whether its explanation of the picture is about as short as the first suspect's, or draws the same.</param>
/// <param name="HasSymptoms">Whether the picture certainly shows the mistakes' symptoms: each is made in the way that its symptom describes, and
/// they explain the picture.</param>
public sealed record Suspect(
    IReadOnlyList<Change> Mistakes, double Unexplained, bool OtherSample, IReadOnlyList<Mistake> Twins, IReadOnlyList<string> MissingParts,
    bool SamePicture, bool AsLikely, bool HasSymptoms)
{
    /// <summary>A right program.</summary>
    internal static Suspect None { get; } = new([], 0, false, [], [], false, false, false);

    /// <summary>Other formulas of the same step in which a slip draws the same, in words.</summary>
    public IReadOnlyList<string> OtherFormulas { get; init; } = [];

    /// <summary>The mistakes, and that of the sample point if it is another.</summary>
    public IEnumerable<Change> AllMistakes => OtherSample ? Mistakes.Append(MistakeCatalog.OtherSample) : Mistakes;
}
