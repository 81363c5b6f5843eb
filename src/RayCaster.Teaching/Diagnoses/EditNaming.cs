namespace RayCaster.Teaching;

/// <summary>The place of an edit in the slides' formulas, as far as the picture shows it.</summary>
/// <param name="Section">The step, as its formulas' text calls it; several with commas.</param>
/// <param name="Step">The name that the edited formula computes; null if several do.</param>
/// <param name="Formula">That formula as the slides have it; null if there are several.</param>
public sealed record EditPlace(string Section, string? Step, string? Formula);

/// <summary>Gives small edits of formulas hints like those of known mistakes: first the symptom, at last what was written.</summary>
internal static class EditNaming
{
    /// <summary>The id of all edits that are not in the catalogue.</summary>
    public const string Id = "edit";

    /// <summary>Of edits that draw the same, those that cost more than the likeliest by this are ignored.</summary>
    private const double Likely = 0.25;

    /// <summary>Most names that are listed where a picture cannot tell formulas apart.</summary>
    private const int MaxNames = 5;

    /// <summary>The known mistake whose label the likeliest labelled edit has; else a mistake that is not in the catalogue.</summary>
    /// <param name="edits">All that draw the same, the likeliest first.</param>
    public static Mistake Of(IReadOnlyList<FormulaEdit> edits)
    {
        var first = edits[0];
        FormulaEdit[] likely = [.. edits.Where(edit => edit.Cost <= first.Cost + Likely)];
        if (Array.Find(likely, edit => edit.Label is not null) is { } known)
            return MistakeCatalog.Named(known.Label!)!.Worded($"{SectionOf(known.Section.Kind)}: {Describe(known)}", first.On);

        SectionKind[] kinds = [.. likely.Select(edit => edit.Section.Kind).Distinct()];
        var isOneStep = kinds.Length == 1;
        // Other styles have other formulas: the texts use those of the likeliest style.
        Formula?[] formulas = [.. likely.Where(edit => edit.Right == first.Right).Select(edit => edit.Formula).Distinct()];
        var formula = isOneStep && formulas.Length == 1 ? formulas[0] : null;
        var section = string.Join(", ", kinds.Select(SectionOf));
        return new(Id, Mistake.AffectedBy(first.Section.Kind), first.Section.Slide, $"{section}: {Describe(first)}", new(
            isOneStep ? SymptomOf(kinds[0]) : "Several steps could make this picture.",
            formula is not null ? $"Look at {formula.Computed}. {EditOperators.QuestionOf(first.Operator)}"
                : isOneStep ? $"Something is wrong in the formulas of the step \"{section}\"; this scene cannot tell {NamesOf(formulas)} apart."
                : $"Something is wrong in one of these steps: {section}. This scene cannot tell them apart.",
            $"{(formula is null ? "For example, it" : "It")} looks as if {Describe(first)}."), first.On)
        {
            Place = new(section, formula?.Computed, formula?.ToString()),
        };
    }

    private static string SectionOf(SectionKind kind) => kind.ToString().ToLowerInvariant();

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
        _ => $"Only {ShapeOf(kind).Many} are wrong; all else is right.",
    };

    private static ShapeKind ShapeOf(SectionKind kind) => ShapeKind.Of(kind.ToString().ToLowerInvariant())!;
}
