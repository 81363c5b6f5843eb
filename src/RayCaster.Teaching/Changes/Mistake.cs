namespace RayCaster.Teaching.Changes;

/// <summary>Help in three steps: the first ones leave the work to the student.</summary>
/// <param name="Symptom">What one sees.</param>
/// <param name="Question">What to ask oneself.</param>
/// <param name="Answer">What to write instead.</param>
public sealed record Hint(string Symptom, string Question, string Answer);

/// <summary>A mistake that people make in a ray caster: an entry of Mistakes.txt.</summary>
public sealed class Mistake
{
    /// <param name="words">What its entry says besides: "rounding", "rare", "missing PART" and the like.</param>
    internal Mistake(string id, string slide, Hint hint, IReadOnlyDictionary<string, string> words, IEnumerable<Change> changes)
    {
        (Id, Slide, Hint) = (id, slide, hint);
        IsWithinRounding = words.ContainsKey("rounding");
        MissingPart = words.GetValueOrDefault("missing");
        HiddenBy = words.GetValueOrDefault("hidden")?["by ".Length..].Split(", ") ?? [];
        var bits = Priors.Known + (words.ContainsKey("rare") ? Priors.Rare : 0);
        Changes = [.. changes.Select((change, i) => change with { Mistake = this, IsUsual = i == 0, Bits = bits + (i == 0 ? 0 : Priors.Variant) })];
        Steps = Changes.SelectMany(change => change.OwnSteps).ToHashSet();
        if (IsOtherSample) Changes = [.. Changes.Select(change => change with { Bits = Priors.OtherSample })];
    }

    /// <summary>A short name without blanks, the same for ever.</summary>
    public string Id { get; }

    /// <summary>The title of the slide with the right formula; docs/slides-to-code.md names its code.</summary>
    public string Slide { get; }

    /// <summary>Help in three steps.</summary>
    public Hint Hint { get; }

    /// <summary>What people write who make it, each with its own cause; the first is the usual one.</summary>
    public IReadOnlyList<Change> Changes { get; }

    /// <summary>What people write who make it, as a rule.</summary>
    public Change Usual => Changes[0];

    /// <summary>What is wrong in the program, in one line, as a rule.</summary>
    public string Cause => Usual.Cause;

    /// <summary>The steps whose formulas it changes in some program.</summary>
    internal IReadOnlySet<StepKind> Steps { get; }

    /// <summary>The part of a program that is not written yet if it draws like this; null if it is no such part.</summary>
    internal string? MissingPart { get; }

    /// <summary>What in a scene hides it, by the names of the report's reasons.</summary>
    internal IReadOnlyList<string> HiddenBy { get; }

    /// <summary>Whether it changes channels by at most a level, like rounding, so it makes no pixel wrong.</summary>
    internal bool IsWithinRounding { get; }

    /// <summary>Whether rays pass through the other sample point of each pixel. Beside a mistake that is none.</summary>
    internal bool IsOtherSample => Steps.All(step => step.IsOfSample());

    /// <summary>Whether a scene has what the mistake changes; if not, its picture is right.</summary>
    public bool Touches(Scene scene) => Touches(scene.Models.Select(model => model.Kind));

    /// <summary>Whether the mistake changes programs that draw these kinds of shape, by their names in scene files.</summary>
    public bool Touches(IEnumerable<string> kinds) => Steps.Any(step => !step.IsOfShape()) || kinds.Any(Touches);

    /// <summary>Whether it changes the formulas of a kind of shape, or only its rule.</summary>
    internal bool Touches(string kind) => ShapeKind.Find(kind) is { } shape && Steps.Contains(shape.Step);

    /// <summary>Its id.</summary>
    public override string ToString() => Id;
}
