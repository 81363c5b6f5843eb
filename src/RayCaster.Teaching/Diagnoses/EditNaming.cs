namespace RayCaster.Teaching;

/// <summary>The place of an edit in the slides' formulas, as far as the picture shows it.</summary>
public sealed record EditPlace
{
    internal EditPlace(IReadOnlyList<SectionKind> steps, string? step, string? formula) => (Steps, Step, Formula) = (steps, step, formula);

    internal IReadOnlyList<SectionKind> Steps { get; }

    /// <summary>The step, as its formulas' text calls it; several with commas.</summary>
    public string Section => string.Join(", ", Steps.Select(EditNaming.SectionOf));

    /// <summary>The name that the edited formula computes; null if several do.</summary>
    public string? Step { get; }

    /// <summary>That formula as the slides have it; null if there are several.</summary>
    public string? Formula { get; }
}

/// <summary>Gives small edits of formulas hints like those of known mistakes: first the symptom, at last what was written.</summary>
internal static class EditNaming
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
        FormulaEdit[] likely = [.. slips.Select(change => change.Slip!).Where(edit => edit.Cost <= first.Slip!.Cost + Likely)];
        var edit = likely[0];
        if (Array.Find(likely, other => other.Label is not null) is { } known)
            return first with { Mistake = MistakeCatalog.Named(known.Label!), Cause = $"{SectionOf(known.Section.Kind)}: {Describe(known)}" };

        SectionKind[] kinds = [.. likely.Select(other => other.Section.Kind).Distinct()];
        var isOneStep = kinds.Length == 1;
        // Other styles have other formulas: the texts use those of the likeliest style.
        Formula?[] formulas = [.. likely.Where(other => other.Right == edit.Right).Select(other => other.Formula).Distinct()];
        var formula = isOneStep && formulas.Length == 1 ? formulas[0] : null;
        var place = new EditPlace(kinds, formula?.Computed, formula?.ToString());
        return first with
        {
            Place = place,
            Cause = $"{place.Section}: {Describe(edit)}",
            Hint = new(
                isOneStep ? SymptomOf(kinds[0]) : "Several steps could make this picture.",
                formula is not null ? $"Look at {formula.Computed}. {EditOperators.QuestionOf(edit.Operator)}"
                    : isOneStep ? $"Something is wrong in the formulas of the step \"{place.Section}\"; this scene cannot tell {NamesOf(formulas)} apart."
                    : $"Something is wrong in one of these steps: {place.Section}. This scene cannot tell them apart.",
                $"{(formula is null ? "For example, it" : "It")} looks as if {Describe(edit)}."),
        };
    }

    internal static string SectionOf(SectionKind kind) => kind.ToString().ToLowerInvariant();

    private static string Describe(FormulaEdit edit)
    {
        var where = edit.Formula is { } formula ? $"in {formula}" : "in the whole formula";
        return edit.Operator switch
        {
            EditOperator.MissingCondition => $"{edit.Meant} was not tested {where}",
            EditOperator.ExtraCondition => $"{edit.Written} was tested {where}",
            _ => $"{edit.Written} was written instead of {edit.Meant} {where}",
        };
    }

    private static string NamesOf(IEnumerable<Formula?> formulas)
    {
        string[] names = [.. formulas.Select(formula => formula?.Computed ?? "all of them").Distinct()];
        return names.Length > MaxNames ? "its formulas" : string.Join(names.Length == 2 ? " and " : ", ", names);
    }

    private static string SymptomOf(SectionKind kind) => kind switch
    {
        SectionKind.Vectors => "All that is computed with products and lengths of vectors is wrong.",
        SectionKind.Camera or SectionKind.File or SectionKind.Sample or SectionKind.Pixel =>
            "Everything stands elsewhere or is deformed: the rays are wrong.",
        SectionKind.Rule or SectionKind.Nearest =>
            "What is drawn is right, but it is cut off where it should show, or shows where it should be cut off.",
        SectionKind.Light => "All outlines are right, only the light is not.",
        SectionKind.Bytes => "All outlines are right, only the colours are not.",
        _ => $"Only {ShapeKind.Of(kind).Many} are wrong; all else is right.",
    };
}
