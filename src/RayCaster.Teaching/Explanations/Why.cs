namespace RayCaster.Teaching;

/// <summary>Why a formula gives NaN: the test that failed, or the operation without a result, with its numbers.</summary>
internal static class Why
{
    /// <summary>The reasons, from the derivation of a crossing that is NaN.</summary>
    public static string IsNoNumber(Term term)
    {
        var reasons = new List<string>();
        Find(term, reasons);
        return string.Join("; ", reasons.Distinct());
    }

    private static void Find(Term term, List<string> reasons)
    {
        if (!RuntimeHelpers.TryEnsureSufficientExecutionStack()) return;
        switch (term.Operation)
        {
            case Operation.If when term.A.Value == 0:
                FindFailure(term.A, null, reasons);
                return;
            case Operation.If or Operation.Name or Operation.Instead:
                Find(term.Operation == Operation.Name ? term.A : term.B, reasons);
                return;
            case Operation.Select:
                Find(term.A.Value != 0 ? term.B : term.C, reasons);
                return;
            case Operation.Constant:
                reasons.Add("the formula says NaN");
                return;
        }
        foreach (var part in term.Parts)
        {
            if (!double.IsNaN(part.Value)) continue;
            Find(part, reasons);
            return;
        }
        reasons.Add($"{new TermText().Of(term)} is no number");
    }

    private static void FindFailure(Term mask, string? formula, List<string> reasons)
    {
        switch (mask.Operation)
        {
            case Operation.Name:
                FindFailure(mask.A, mask.Step!.Formula, reasons);
                return;
            case Operation.And or Operation.Or:
                foreach (var part in mask.Parts)
                    if (part.Value == 0) FindFailure(part, null, reasons);
                return;
            case Operation.Less or Operation.Greater or Operation.LessOrEqual or Operation.GreaterOrEqual:
                if (double.IsNaN(mask.A.Value)) Find(mask.A, reasons);
                else if (double.IsNaN(mask.B.Value)) Find(mask.B, reasons);
                else reasons.Add(Failure(mask, formula));
                return;
            default:
                reasons.Add(formula is null ? "a test of the formula fails" : $"{formula} is false");
                return;
        }
    }

    private static string Failure(Term comparison, string? formula)
    {
        var (left, right) = Digits.Apart(comparison.A.Value, comparison.B.Value);
        var sign = TermText.Comparison(comparison.Operation);
        var working = new TermText().Of(comparison.A);
        var source = formula is not null ? $"{formula}: "
            : comparison.A.Chosen.Label is { } name ? $"{name} = "
            : working != left ? $"{working} = "
            : "";
        return $"{source}{left} {sign} {right} is false";
    }
}
