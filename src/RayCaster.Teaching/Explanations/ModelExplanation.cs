namespace RayCaster.Teaching.Explanations;

/// <summary>One model in the explanation of a pixel: its formula evaluated over <see cref="Derivation"/>, which records each step.</summary>
internal sealed class ModelExplanation
{
    private readonly PixelExplanation pixel;

    /// <param name="pixel">Its ray, its winner and its neighbours are known.</param>
    public ModelExplanation(PixelExplanation pixel, RayResult result)
    {
        this.pixel = pixel;
        Result = result;
        Shape = result.Shape;
        var ray = new Ray<Derivation>(
            ((Vector3<Derivation>)pixel.Ray.Origin).As("P", ""), ((Vector3<Derivation>)pixel.Ray.Direction).As("d", ""));
        if (Shape?.Intersect(ray) is { } derived)
        {
            var corners = Corners();
            Slabs = SlabExplanation.Create(Shape, derived);
            var writer = new TermText(
                [.. corners.Select(step => step.Value).OfType<Vector3>().SelectMany(v => (double[])[v.X, v.Y, v.Z]),
                 .. Slabs.SelectMany(slab => (double[])[slab.Enters, slab.Leaves])]);
            Steps = [.. corners, .. NamedValue.LeadingTo(writer, derived.Near, derived.Far)];
            Crossings = [.. Find(derived, writer)];
        }
        else if (Shape is not null) Crossings = [OfPlainDoubles()];

        Reason = result.Outcome.Counts() ? ReasonOfHit(result.T)
            : Shape is null ? "the ray misses all its triangles"
            : string.Join("; ", Crossings.Select(crossing => crossing.Reason).Distinct());
    }

    public RayResult Result { get; }

    /// <summary>Its name, or its path in the scene file.</summary>
    public string Name => pixel.NameOf(Result.Index);

    public string Reason { get; }

    /// <summary>The steps of its formula; empty for a scalar shape, of which only t is known.</summary>
    public IReadOnlyList<NamedValue> Steps { get; } = [];

    /// <summary>The crossings, nearest first; if there is none, one entry says why.</summary>
    public IReadOnlyList<CrossingExplanation> Crossings { get; } = [];

    /// <summary>A box's slabs; empty for other shapes.</summary>
    public IReadOnlyList<SlabExplanation> Slabs { get; } = [];

    /// <summary>A triangle's barycentric numbers w, u, v, which add up to 1; null for other shapes and for a triangle seen edge-on.</summary>
    public IReadOnlyList<double>? Weights => Shape is Model<Triangle> ? OutcomeReason.Weights(Steps) : null;

    /// <summary>Which neighbouring pixels show the model, which this pixel does not show, in words; null if none does.</summary>
    public string? Beside => Result.Index != pixel.Winner
        && string.Join(", ", pixel.Neighbours.Where(beside => beside.Model == Result.Index).Select(beside => beside.Where)) is { Length: > 0 } where
            ? where : null;

    /// <summary>What is explained: of a mesh one triangle; null where the ray crosses none.</summary>
    private Model? Shape { get; }

    /// <summary>The result of a crossing that counts.</summary>
    private string ReasonOfHit(double t)
    {
        if (Result.Outcome == Outcome.Shows) return "the nearest that counts: the pixel shows it";
        var shown = pixel.NameOf(pixel.Winner);
        var nearest = pixel.Hit.T;
        if (t == nearest) return $"a tie: {shown} has the same t and stands earlier in the scene";
        var (a, b) = Digits.Apart(nearest, t);
        return $"hidden by {shown}, whose t = {a} < {b}";
    }

    private List<CrossingExplanation> Find(Crossings<Derivation> derived, TermText writer)
    {
        var crossings = new List<CrossingExplanation>();
        foreach (var term in (Term[])[derived.Near.Term, derived.Far.Term])
        {
            var t = term.Value;
            if (double.IsNaN(t) && crossings.Count > 0) continue; // a surface that is crossed only once, or the same reason again
            var (outcome, reason) = Outcomes.Classify(t, pixel.Ray) switch
            {
                Outcome.Shows when crossings is [{ Outcome: Outcome.Shows or Outcome.Hidden }] =>
                    (Outcome.NotNeeded, "the crossing before it counts already"),
                Outcome.Shows => (Result.Outcome, ReasonOfHit(t)),
                Outcome.Misses => (Outcome.Misses, OutcomeReason.NoCrossing(Shape!, Steps, Slabs, term)),
                var refused => (refused, OutcomeReason.Format(refused, t, pixel)),
            };
            var isStep = term.Chosen.Operation is Operation.Name;
            var untested = double.IsNaN(t) && term.Operation is Operation.If && double.IsFinite(term.B.Value) ? term.B.Value : (double?)null;
            crossings.Add(new(t, t * pixel.Ray.DepthPerT, outcome, reason, isStep ? "" : writer.Write(term), untested));
        }
        return crossings;
    }

    /// <summary>The crossing of a scalar shape.</summary>
    private CrossingExplanation OfPlainDoubles()
    {
        var t = Result.T;
        var reason = Result.Outcome.Counts() ? ReasonOfHit(t)
            : Result.Outcome != Outcome.Misses ? OutcomeReason.Format(Result.Outcome, t, pixel)
            : double.IsFinite(t) ? "its Intersect gives no hit, though this t counts"
            : "its Intersect finds no crossing";
        return new(t, t * pixel.Ray.DepthPerT, Result.Outcome, reason);
    }

    /// <summary>A triangle's corners as seen along the ray, in which its formula computes w, u and v.</summary>
    private IReadOnlyList<NamedValue> Corners()
    {
        if (Shape is not Model<Triangle> { Primitive: var triangle }) return [];
        var along = new RaySpace<Scalar>(new(pixel.Ray.Origin, pixel.Ray.Direction));
        return [Corner('A', triangle.A), Corner('B', triangle.B), Corner('C', triangle.C)];

        NamedValue Corner(char name, Vector3 point)
        {
            var p = along.Transform(point);
            var seen = new Vector3(p.X, p.Y, p.Z);
            return new($"{char.ToLowerInvariant(name)}", $"{name} seen along the ray", Digits.Format(seen), seen);
        }
    }
}

/// <summary>A crossing of a ray and a model, or what would be one.</summary>
/// <param name="T">The ray parameter; NaN where there is no crossing.</param>
/// <param name="Z">What zNear and zFar are compared with.</param>
/// <param name="Numbers">How t is computed from the named steps of the formula; empty where it is one of them.</param>
/// <param name="Untested">Where a test of the formula failed: the t that it would give without the test, for example that of the circle's
/// plane.</param>
internal sealed record CrossingExplanation(double T, double Z, Outcome Outcome, string Reason, string Numbers = "", double? Untested = null);
