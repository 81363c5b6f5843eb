namespace RayCaster.Teaching;

/// <summary>A step of a formula with the numbers of one pixel.</summary>
/// <param name="Name">Its name on the slide.</param>
/// <param name="Formula">How it is computed, as written in the code.</param>
/// <param name="Numbers">The formula with this pixel's numbers; named steps before it stand as their values.</param>
/// <param name="Values">The result: one number, or the three of a vector.</param>
public sealed record FormulaStep(string Name, string Formula, string Numbers, IReadOnlyList<double> Values)
{
    /// <summary>Whether it is a test: its value is 1 for true and 0 for false.</summary>
    public bool IsTest { get; init; }

    /// <summary>The result of a step that gives one number.</summary>
    public double Value => Values[0];

    internal Vector3 Vector => new(Values[0], Values[1], Values[2]);

    /// <summary>The named steps from which some numbers were computed, in the order of the computation.</summary>
    internal static IReadOnlyList<FormulaStep> LeadingTo(params ReadOnlySpan<Derivation> results) => LeadingTo(new TermText(), results);

    /// <inheritdoc cref="LeadingTo(ReadOnlySpan{Derivation})"/>
    internal static IReadOnlyList<FormulaStep> LeadingTo(TermText writer, params ReadOnlySpan<Derivation> results)
    {
        var (found, seen) = (new List<StepName>(), new HashSet<object>(ReferenceEqualityComparer.Instance));
        foreach (var result in results) Walk(result.Term);
        return [.. found.OrderBy(step => step.Number).Select(Of)];

        void Walk(Term term)
        {
            if (!seen.Add(term) || !RuntimeHelpers.TryEnsureSufficientExecutionStack()) return;
            if (term.Step is not { } step)
            {
                foreach (var part in term.Parts) Walk(part);
                return;
            }
            if (!seen.Add(step) || step.Formula.Length == 0) return;
            foreach (var coordinate in step.Terms) Walk(coordinate.A);
            found.Add(step);
        }

        FormulaStep Of(StepName step) =>
            new(step.Name, step.Formula, writer.Of(step.Terms), Array.ConvertAll(step.Terms, coordinate => coordinate.Value))
            {
                IsTest = step.Terms[0].IsTest,
            };
    }
}
