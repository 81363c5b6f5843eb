namespace RayCaster.Teaching.Changes;

/// <summary>The place of an edit in the slides' formulas, as far as the picture shows it.</summary>
public sealed record FormulaPlace
{
    internal FormulaPlace(IReadOnlyList<StepKind> steps, string? name, string? formula) => (Steps, Name, Formula) = (steps, name, formula);

    internal IReadOnlyList<StepKind> Steps { get; }

    /// <summary>The step, as its formulas' text calls it; several with commas.</summary>
    public string Step => string.Join(", ", Steps.Select(step => step.InWords()).Distinct());

    /// <summary>The name that the edited formula computes; null if several do.</summary>
    public string? Name { get; }

    /// <summary>That formula as the slides have it; null if there are several.</summary>
    public string? Formula { get; }
}

/// <summary>Gives small edits of formulas hints like those of known mistakes: first the symptom, at last what was written.</summary>
internal static class MutationNaming
{
    /// <summary>Of edits that draw the same, those that cost more than the likeliest by this are ignored.</summary>
    private const double Likely = 0.25;

    /// <summary>Most names that are listed where a picture cannot tell formulas apart.</summary>
    private const int MaxNames = 5;

    /// <summary>The likeliest slip, with the known mistake whose label it has, or with words of its own.</summary>
    /// <param name="slips">All that draw the same, the likeliest first.</param>
    public static Change Named(IReadOnlyList<Change> slips)
    {
        var first = slips[0];
        var likely = LikelyOf(slips);
        if (Array.Find(likely, other => other.Label is not null) is { } known)
            return first with { Mistake = MistakeCatalog.Named(known.Label!), Cause = $"{known.Step.Kind.InWords()}: {Describe(known)}" };
        return InOwnWords(first, likely);
    }

    /// <summary>A slip with a mistake's name, in words of its own.</summary>
    public static Change Unnamed(Change slip)
    {
        var mutation = slip.Mutation! with { Label = null };
        return InOwnWords(slip with { Mutation = mutation, Mistake = null, Similar = slip.Mistake }, [mutation]);
    }

    private static Mutation[] LikelyOf(IReadOnlyList<Change> slips) =>
        [.. slips.Select(change => change.Mutation!).Where(mutation => mutation.Cost <= slips[0].Mutation!.Cost + Likely)];

    private static Change InOwnWords(Change first, Mutation[] likely)
    {
        var mutation = likely[0];
        StepKind[] kinds = [.. likely.Select(other => other.Step.Kind).Distinct()];
        var isOneStep = kinds.Length == 1;
        // Other styles have other formulas: the texts use those of the likeliest style.
        Formula?[] formulas = [.. likely.Where(other => other.Right == mutation.Right).Select(other => other.Formula).Distinct()];
        var formula = isOneStep && formulas.Length == 1 ? formulas[0] : null;
        var place = new FormulaPlace(kinds, formula?.Computed, formula?.ToString());
        return first with
        {
            Place = place,
            Cause = $"{place.Step}: {Describe(mutation)}",
            Hint = new(
                isOneStep ? FormulaBook.Slides.SymptomOf(kinds[0]) : "",
                formula is not null ? $"Look at {FormulaBook.Slides.InWords(formula.Computed)}. {mutation.Operator.Question}"
                    : isOneStep ? $"Something is wrong in the formulas of the step \"{place.Step}\"; " +
                        $"this scene cannot tell {NamesOf(formulas)} apart."
                    : $"Something is wrong in one of these steps: {place.Step}. This scene cannot tell them apart.",
                $"{(formula is null ? "For example, it" : "It")} looks as if {Describe(mutation)}."),
        };
    }

    private static string Describe(Mutation mutation) => mutation.Operator.Tell(mutation.Meant, mutation.Written)
        + (mutation.Formula is { } formula ? $" in {formula}" : " in the whole formula");

    private static string NamesOf(IEnumerable<Formula?> formulas)
    {
        string[] names = [.. formulas.Select(formula => formula is null ? "all of them" : FormulaBook.Slides.InWords(formula.Computed)).Distinct()];
        return names.Length > MaxNames ? "its formulas" : string.Join(names.Length == 2 ? " and " : ", ", names);
    }
}
