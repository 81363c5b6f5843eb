namespace RayCaster.Teaching;

/// <summary>Explains models for a pixel's ray: evaluates their formulas over <see cref="Derivation"/>, which records each step.</summary>
internal sealed class ModelExplainer(PixelExplanation pixel)
{
    private readonly Ray cast = pixel.Ray;
    private readonly Camera camera = pixel.Scene.Camera;

    private readonly Ray<Derivation> ray = new(
        ((Vector3<Derivation>)pixel.Ray.Origin).As("P", ""), ((Vector3<Derivation>)pixel.Ray.Direction).As("d", ""));

    public ModelExplanation Explain(Trial trial)
    {
        IReadOnlyList<FormulaStep> steps = [];
        IReadOnlyList<SlabExplanation> slabs = [];
        IReadOnlyList<CrossingExplanation> crossings = [];
        var shape = trial.Shape;
        if (shape?.Intersect(ray) is { } derived)
        {
            (var corners, slabs) = (Corners(shape), Slabs(shape, derived));
            var writer = new TermText(
                [.. corners.Select(step => step.Value).OfType<Vector3>().SelectMany(v => (double[])[v.X, v.Y, v.Z]),
                 .. slabs.SelectMany(slab => (double[])[slab.Enters, slab.Leaves])]);
            steps = [.. corners, .. FormulaStep.LeadingTo(writer, derived.Near, derived.Far)];
            crossings = Crossings(trial, derived, term => Reasons.NoCrossing(shape, steps, slabs, term), writer);
        }
        else if (shape is not null) crossings = [OfPlainDoubles(trial)];

        var (outcome, reason) = trial.Hit is { } hit ? Hit(trial.Index, hit)
            : (trial.Outcome, shape is null ? "the ray passes all its triangles by"
                : string.Join("; ", crossings.Select(crossing => crossing.Reason).Distinct()));
        return new(trial, pixel.NameOf(trial.Index), outcome, reason, steps, crossings, slabs,
            shape is Model<Triangle> ? Reasons.Weights(steps) : null, Beside(trial.Index));
    }

    /// <summary>What becomes of a crossing that counts.</summary>
    private (Outcome Outcome, string Reason) Hit(int model, double t)
    {
        if (model == pixel.Winner) return (Outcome.Shows, "the nearest that counts: the pixel shows it");
        var shown = pixel.NameOf(pixel.Winner);
        if (t == cast.HitParameter) return (Outcome.Hidden, $"a tie: {shown} has the same t and stands earlier in the scene");
        var (a, b) = Digits.Apart(cast.HitParameter, t);
        return (Outcome.Hidden, $"hidden by {shown}, whose t = {a} < {b}");
    }

    private List<CrossingExplanation> Crossings(Trial trial, Crossings<Derivation> derived, Func<Term, string> noCrossing, TermText writer)
    {
        var crossings = new List<CrossingExplanation>();
        foreach (var term in (Term[])[derived.Near.Term, derived.Far.Term])
        {
            var t = term.Value;
            if (double.IsNaN(t) && crossings.Count > 0) continue; // a surface that is crossed only once, or the same reason again
            var (outcome, reason) = Outcomes.Of(t, cast) switch
            {
                Outcome.Shows when crossings is [{ Outcome: Outcome.Shows or Outcome.Hidden }] =>
                    (Outcome.NotNeeded, "the crossing before it counts already"),
                Outcome.Shows => Hit(trial.Index, t),
                Outcome.NoNumber => (Outcome.NoNumber, noCrossing(term)),
                var refused => (refused, Reasons.Of(refused, t, t * cast.ZPerT, camera)),
            };
            var isStep = term.Chosen.Operation is Operation.Name;
            crossings.Add(new(t, t * cast.ZPerT, outcome, reason, isStep ? "" : writer.Of(term), Untested(term)));
        }
        return crossings;
    }

    /// <summary>The t that a crossing would have without the test that failed.</summary>
    private static double? Untested(Term term) =>
        double.IsNaN(term.Value) && term.Operation is Operation.If && double.IsFinite(term.B.Value) ? term.B.Value : null;

    /// <summary>The crossing of a model in plain doubles and ifs.</summary>
    private CrossingExplanation OfPlainDoubles(Trial trial)
    {
        var (t, z) = (trial.T, trial.T * cast.ZPerT);
        var (outcome, reason) = trial.Hit is { } hit ? Hit(trial.Index, hit)
            : !trial.Outcome.IsMiss() ? (trial.Outcome, Reasons.Of(trial.Outcome, t, z, camera))
            : (Outcome.NoNumber, double.IsFinite(t) ? "its Intersect gives no hit, though this t counts" : "its Intersect finds no crossing");
        return new(t, z, outcome, reason);
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

    /// <summary>The slabs of a box, by the steps t0 and t1 of its formula; empty for other shapes.</summary>
    private static SlabExplanation[] Slabs(Model shape, Crossings<Derivation> derived)
    {
        if (shape is not Model<Aabb> { Primitive: var (B0, B1) }) return [];
        var steps = FormulaStep.LeadingTo(derived.Near).ToLookup(step => step.Name, step => step.Value);
        if ((steps["t0"].ToArray(), steps["t1"].ToArray()) is not ([double x0, double y0, double z0], [double x1, double y1, double z1])) return [];
        SlabExplanation[] slabs = [new('x', B0.X, B1.X, x0, x1), new('y', B0.Y, B1.Y, y0, y1), new('z', B0.Z, B1.Z, z0, z1)];
        var (last, first) = (slabs.MaxBy(slab => slab.Enters), slabs.MinBy(slab => slab.Leaves));
        return Array.ConvertAll(slabs, slab => slab with { DecidesEntry = slab == last, DecidesExit = slab == first });
    }

    /// <summary>Which neighbouring pixels show a model that this pixel does not show; null for none.</summary>
    private string? Beside(int model)
    {
        string[] where = [.. pixel.Neighbours.Where(neighbour => neighbour.Model == model).Select(neighbour => neighbour.Where)];
        return model == pixel.Winner || where.Length == 0 ? null : string.Join(", ", where);
    }
}
