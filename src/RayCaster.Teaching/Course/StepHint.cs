namespace RayCaster.Teaching.Course;

/// <summary>The message of a failing picture test of the lab: only what the picture shows.</summary>
public static class StepHint
{
    /// <summary>How many mistakes are named besides the first, of those that draw the same picture.</summary>
    private const int MaxTwins = 2;

    /// <summary>Lines of text, indented.</summary>
    /// <param name="picture">The student's picture, in the scene's size.</param>
    /// <param name="step">
    /// The step that the test is of. The code of the steps before it is less likely to be wrong, and that of later steps is not written. 0 for a
    /// test of no step.
    /// </param>
    public static string Format(Scene scene, Picture picture, int step, HintLevel level) =>
        Format(scene, Diagnose(scene, picture, step), step, level);

    /// <summary>The same, on a new line, where a mistake in a step's code explains all wrong pixels; otherwise empty.</summary>
    public static string OfAllPixels(Scene scene, Picture picture, int step, HintLevel level) =>
        Diagnose(scene, picture, step, new()) is { Suspects: [{ Unexplained: 0, Mistakes: [var mistake] }, ..] } diagnosis
            && diagnosis.Kind == DiagnosisKind.Mistake && LabSteps.IsOf(mistake, step) ? "\n" + Format(scene, diagnosis, step, level) : "";

    internal static string Format(Scene scene, DiagnosisResult diagnosis, int step, HintLevel level) =>
        string.Join("\n", Lines(scene, diagnosis, step, level).Select(line => "  " + line));

    internal static DiagnosisResult Diagnose(Scene scene, Picture picture, int step, SearchBudget? budget = null) => step == 0
        ? DiagnosisResult.Find(scene, picture)
        : new Diagnoser(scene, budget: budget, possible: mistake => Slides.StepOf(mistake.Slide) <= step)
            .Diagnose(picture, LabSteps.DoneAt(scene, step), mistake => LabSteps.IsOf(mistake, step));

    private static IEnumerable<string> Lines(Scene scene, DiagnosisResult diagnosis, int step, HintLevel level)
    {
        if (diagnosis is not { Kind: DiagnosisKind.Mistake, Suspects: [var suspect, ..] }) return OfPicture(scene, diagnosis, step, level);
        // light, zNear and zFar may not be written yet
        Change[] mistakes = [.. suspect.Mistakes.Where(mistake => step == 0 || Slides.StepOf(mistake.Slide) <= step)];
        if (mistakes.Length == 0) return ["Only a few pixels are wrong: too few to name a mistake.", .. OfStep(step, level)];
        var twins = suspect.Twins.Where(twin => LabSteps.IsOf(twin.Usual, step)).Take(MaxTwins);
        return mistakes.SelectMany(mistake => OfMistake(mistake, suspect.HasSymptoms, level))
            .Concat(level == HintLevel.Symptom ? [] : twins.SelectMany(twin => OfMistake(twin.Usual, false, level)));
    }

    private static IEnumerable<string> OfMistake(Change mistake, bool hasSymptom, HintLevel level)
    {
        if (hasSymptom) yield return mistake.Hint.Symptom;
        else if (level == HintLevel.Symptom) yield return "A known mistake makes this picture.";
        var question = mistake.Hint.Question; // or a sentence, where the picture cannot tell formulas apart
        if (level == HintLevel.Question) yield return question.EndsWith('?') ? $"Ask yourself: {question}" : question;
        if (level < HintLevel.Answer) yield break;
        yield return hasSymptom ? mistake.Cause : $"For example: {mistake.Cause}"; // in this variant, or in another one
        yield return mistake.Hint.Answer;
        yield return $"Slide \"{mistake.Slide}\"";
    }

    private static IEnumerable<string> OfPicture(Scene scene, DiagnosisResult diagnosis, int step, HintLevel level)
    {
        string[] missing = diagnosis.Kind == DiagnosisKind.TellsNothing
            ? [.. LabSteps.KindsOf(scene, step)]
            : [.. diagnosis.MissingParts.Where(part => part is not (MissingPart.Attenuation or MissingPart.Clipping))];
        if (missing.Length > 0) yield return $"Missing where it should show: {string.Join(", ", missing)}.";
        // A picture without anything in it may have lost its light, or its hits. Once both are written and tested, the step's shape is to blame.
        var isOfTheShape = missing.Length > 0 && diagnosis.Kind == DiagnosisKind.TellsNothing && step > LabSteps.Clipping;
        if (!isOfTheShape) foreach (var sentence in diagnosis.Likely) yield return sentence;
        if (missing.Length == 0 && diagnosis.Likely.Count == 0) yield return "None of the known mistakes makes this picture.";
        foreach (var question in OfStep(step, level)) yield return question;
    }

    private static IEnumerable<string> OfStep(int step, HintLevel level) =>
        level > HintLevel.Symptom && step > 0 && Slides.Steps[step - 1].Question is { } question ? [$"Ask yourself: {question}"] : [];
}
