namespace RayCaster.Teaching;

/// <summary>Explains models for one ray: evaluates their formulas over <see cref="Derivation"/>, which records each step.</summary>
/// <param name="cast">The ray with its nearest hit.</param>
/// <param name="shown">The place of the model that the pixel shows; null for none.</param>
internal sealed class ModelExplainer(Scene scene, Ray cast, int? shown)
{
    private readonly Ray<Derivation> ray = new(
        ((Vector3<Derivation>)cast.Origin).As("P", ""), ((Vector3<Derivation>)cast.Direction).As("d", ""));

    public ModelExplanation Explain(Trial trial)
    {
        var part = trial.Mesh is { } mesh ? mesh.Triangle : 0;
        var shape = part is { } i && trial.Model is Mesh triangles ? Model.Of(triangles[i]) : trial.Model;
        IReadOnlyList<FormulaStep> steps = [];
        IReadOnlyList<CrossingExplanation> crossings = [];
        if (part is null || shape.Intersect(ray) is not { } derived)
            crossings = trial.Mesh is null ? [Plain(trial)] : [];
        else
        {
            var corners = Corners(shape);
            var slabs = Slabs(shape, FormulaStep.LeadingTo(derived.Near));
            var writer = new TermText(
                corners.SelectMany(step => step.Values).Concat(slabs.SelectMany(slab => (double[])[slab.Enters, slab.Leaves])).ToHashSet());
            steps = [.. corners, .. FormulaStep.LeadingTo(writer, derived.Near, derived.Far)];
            crossings = Crossings(trial, shape, derived, steps, writer);
        }

        var (outcome, reason) = Sum(trial, crossings);
        return new ModelExplanation(trial.Index, ModelName.Plain(scene, trial.Index), trial.Model.Kind, outcome, reason, steps, crossings)
        {
            Slabs = Slabs(shape, steps),
            Weights = shape is Model<Triangle> ? Reasons.Weights(steps) : null,
            Mesh = trial.Mesh,
        };
    }

    private (Outcome Outcome, string Reason) Sum(Trial trial, IReadOnlyList<CrossingExplanation> crossings)
    {
        if (trial.Hit is { } t) return Hit(trial, t);
        if (crossings.Count == 0) return (Outcome.PassesBy, "the ray passes all its triangles by");
        var reasons = crossings.Select(crossing => crossing.Reason).Distinct();
        return (trial.Outcome, string.Join("; ", reasons));
    }

    private (Outcome Outcome, string Reason) Hit(Trial trial, double t)
    {
        if (trial.Index == shown) return (Outcome.Shows, "the nearest that counts: the pixel shows it");
        var name = ModelName.Plain(scene, shown!.Value);
        if (t == cast.HitParameter) return (Outcome.Hidden, $"a tie: {name} has the same t and stands earlier in the scene");
        var (a, b) = Digits.Apart(cast.HitParameter, t);
        return (Outcome.Hidden, $"hidden by {name}, whose t = {a} < {b}");
    }

    private List<CrossingExplanation> Crossings(Trial trial, Model shape, Crossings<Derivation> derived,
        IReadOnlyList<FormulaStep> steps, TermText writer)
    {
        var crossings = new List<CrossingExplanation>();
        var isHit = false;
        foreach (var crossing in (Derivation[])[derived.Near, derived.Far])
        {
            var (t, term) = (crossing.Value, crossing.Term);
            if (double.IsNaN(t) && crossings.Count > 0) continue; // a surface that is crossed only once, or the same reason again
            var (outcome, reason) = Outcomes.Of(t, cast) switch
            {
                Outcome.Shows when isHit => (Outcome.NotNeeded, "the crossing before it counts already"),
                Outcome.Shows => Hit(trial, t),
                Outcome.NoNumber => (Outcome.NoNumber, Reasons.NoCrossing(shape, steps, term)),
                var refused => (refused, Reasons.Of(refused, t, t * cast.ZPerT, scene.Camera)),
            };
            isHit |= outcome.Counts();
            crossings.Add(new(t, t * cast.ZPerT, outcome, reason, IsStep(term) ? "" : writer.Of(term), Untested(term)));
        }
        return crossings;
    }

    /// <summary>
    /// A triangle's corners as seen along the ray. The triangle's formula does not name them: with one more name there, the compiler would no
    /// longer inline the operators when it draws.
    /// </summary>
    private IReadOnlyList<FormulaStep> Corners(Model shape)
    {
        if (shape is not Model<Triangle> { Primitive: var (A, B, C) }) return [];
        var along = new AlongRay<Derivation>(ray);
        var (a, b, c) = (along.See(A).As("a", "along.See(A)"), along.See(B).As("b", "along.See(B)"), along.See(C).As("c", "along.See(C)"));
        return FormulaStep.LeadingTo(a.X, a.Y, a.Z, b.X, b.Y, b.Z, c.X, c.Y, c.Z);
    }

    private static bool IsStep(Term term) => term.Chosen.Operation is Operation.Name;

    /// <summary>The t that a crossing would have without the test that failed.</summary>
    private static double? Untested(Term term) =>
        double.IsNaN(term.Value) && term.Operation is Operation.If && double.IsFinite(term.B.Value) ? term.B.Value : null;

    private CrossingExplanation Plain(Trial trial)
    {
        var (t, z) = (trial.Near, trial.Near * cast.ZPerT);
        var (outcome, reason) = trial.Hit is { } hit ? Hit(trial, hit) : Outcomes.Of(t, cast) switch
        {
            Outcome.NoNumber => (Outcome.NoNumber, "its Intersect finds no crossing"),
            Outcome.Shows => (Outcome.NoNumber, "its Intersect gives no hit, though this t counts"),
            var refused => (refused, Reasons.Of(refused, t, z, scene.Camera)),
        };
        return new(t, z, outcome, reason, "", null);
    }

    private static IReadOnlyList<SlabExplanation> Slabs(Model shape, IReadOnlyList<FormulaStep> steps)
    {
        if (shape is not Model<Aabb> { Primitive: var box }) return [];
        var (t0, t1) = (Reasons.Values(steps, "t0"), Reasons.Values(steps, "t1"));
        if ((t0.Length, t1.Length) is not (3, 3)) return [];
        var (enters, leaves) = Reasons.Slabs(t0, t1);
        var (entry, exit) = (Array.IndexOf(enters, enters.Max()), Array.IndexOf(leaves, leaves.Min()));
        double[] lo = [box.Min.X, box.Min.Y, box.Min.Z], hi = [box.Max.X, box.Max.Y, box.Max.Z];
        return [.. Enumerable.Range(0, 3).Select(i =>
            new SlabExplanation("xyz"[i], lo[i], hi[i], t0[i], t1[i], enters[i], leaves[i], i == entry, i == exit))];
    }
}
