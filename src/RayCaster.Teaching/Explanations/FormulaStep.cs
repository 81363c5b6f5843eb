namespace RayCaster.Teaching;

/// <summary>A step of a formula with the numbers of one pixel. Its public properties are its fields in the JSON.</summary>
/// <param name="name">Its name on the slide.</param>
/// <param name="formula">How it is computed, as written in the code.</param>
/// <param name="numbers">The formula with this pixel's numbers; named steps before it stand as their values.</param>
/// <param name="values">The result: one number, or the three of a vector; for a test 1 for true and 0 for false.</param>
internal sealed class FormulaStep(string name, string formula, string numbers, IReadOnlyList<double> values, bool isTest = false)
{
    public string Name => name;

    public string Formula => formula;

    public string Numbers => numbers;

    /// <summary>A bool, a number, or three.</summary>
    public object Value => isTest ? Number != 0 : values is [var only] ? only : values;

    internal IReadOnlyList<double> Values => values;

    internal double Number => values[0];

    internal Vector3 Vector => new(values[0], values[1], values[2]);

    /// <summary>The named steps from which some numbers were computed, in the order of the computation.</summary>
    public static IReadOnlyList<FormulaStep> LeadingTo(params ReadOnlySpan<Derivation> results) => LeadingTo(new TermText(), results);

    /// <inheritdoc cref="LeadingTo(ReadOnlySpan{Derivation})"/>
    public static IReadOnlyList<FormulaStep> LeadingTo(TermText writer, params ReadOnlySpan<Derivation> results)
    {
        var (found, seen) = (new List<StepName>(), new HashSet<object>(ReferenceEqualityComparer.Instance));
        foreach (var result in results) Walk(result.Term);
        return [.. found.OrderBy(step => step.Number).Select(step => new FormulaStep(step.Name, step.Formula, writer.Of(step.Terms),
            Array.ConvertAll(step.Terms, coordinate => coordinate.Value), step.Terms[0].IsTest))];

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
    }
}
