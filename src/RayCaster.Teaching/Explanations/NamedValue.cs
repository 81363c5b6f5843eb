namespace RayCaster.Teaching.Explanations;

/// <summary>A step of a formula with the numbers of one pixel.</summary>
/// <param name="Name">Its name on the slide.</param>
/// <param name="Formula">How it is computed, in the notation of the slides.</param>
/// <param name="Numbers">The formula with this pixel's numbers; named steps before it are written as their values.</param>
/// <param name="Value">The result: a double, a <see cref="Vector3"/>, or for a test a bool.</param>
internal sealed record NamedValue(string Name, string Formula, string Numbers, object Value)
{
    /// <summary>The named steps from which some numbers were computed, in the order of the computation.</summary>
    public static IReadOnlyList<NamedValue> LeadingTo(params ReadOnlySpan<Derivation> results) => LeadingTo(new TermText(), results);

    /// <inheritdoc cref="LeadingTo(ReadOnlySpan{Derivation})"/>
    public static IReadOnlyList<NamedValue> LeadingTo(TermText writer, params ReadOnlySpan<Derivation> results)
    {
        var found = new List<Binding>();
        var seen = new HashSet<object>(ReferenceEqualityComparer.Instance);
        foreach (var result in results) Walk(result.Term);
        return [.. found.OrderBy(step => step.Number)
            .Select(step => new NamedValue(step.Text, step.Formula, writer.Write(step.Terms), ValueOf(step.Terms)))];

        void Walk(Term term)
        {
            if (!seen.Add(term) || !RuntimeHelpers.TryEnsureSufficientExecutionStack()) return;
            if (term.Name is not { } step)
            {
                foreach (var part in term.Parts) Walk(part);
                return;
            }
            if (!seen.Add(step) || step.Formula.Length == 0) return;
            foreach (var coordinate in step.Terms) Walk(coordinate.A);
            found.Add(step);
        }
    }

    private static object ValueOf(Term[] terms) =>
        terms is [var x, var y, var z] ? new Vector3(x.Value, y.Value, z.Value) : terms[0].IsTest ? terms[0].Value != 0 : terms[0].Value;
}
