namespace RayCaster.Teaching.Explanations;

/// <summary>The result of a pixel's ray, for one model.</summary>
/// <param name="T">The t of the hit, else of the crossing that comes closest to counting; not finite if there is none.</param>
/// <param name="Triangle">The index of a mesh's triangle with this t; null for none.</param>
internal sealed record RayResult(Model Model, int Index, Outcome Outcome, double T, int? Triangle = null)
{
    /// <summary>What is explained: the model, or one triangle of a mesh; null where the ray crosses none.</summary>
    public Model? Shape => Model is not Mesh mesh ? Model : Triangle is { } triangle ? Model.Of(mesh[triangle]) : null;

    /// <param name="nearest">The ray's nearest hit.</param>
    public static RayResult Create(Model model, int index, Ray ray, Hit nearest)
    {
        int? triangle = null;
        var outcome = model is Mesh mesh ? ClassifyMesh(mesh, ray, out var t, out triangle) : Classify(model, ray, out t);
        var result = new RayResult(model, index, outcome, t, triangle);
        return result.Outcome == Outcome.Shows && index != nearest.Model ? result with { Outcome = Outcome.Hidden } : result;
    }

    /// <summary>The result of a ray, for one model, whatever else is in the scene: <see cref="Outcome.Shows"/> for a hit. Quick enough for all
    /// rays of a picture, also where a mesh has many triangles.</summary>
    /// <param name="t">As <see cref="T"/>.</param>
    public static Outcome Classify(Model model, Ray ray, out double t) =>
        model is Mesh mesh ? ClassifyMesh(mesh, ray, out t, out _)
        : model.Intersect(new Ray<Scalar>(ray.Origin, ray.Direction)) is { } crossings ? JudgeShape(ray, crossings, out t)
        : JudgeByHits(model, ray, out t);

    private static Outcome JudgeShape(Ray ray, Crossings<Scalar> crossings, out double t)
    {
        t = ray.ClipRange.First(crossings, (Scalar)ray.DepthPerT);
        if (!double.IsNaN(t)) return Outcome.Shows;

        // The far crossing comes closer to counting, unless both are too far away.
        t = double.IsFinite(crossings.Far) && Outcomes.Classify(crossings.Near, ray) != Outcome.BeyondFar ? crossings.Far : crossings.Near;
        return Outcomes.Classify(t, ray);
    }

    /// <summary>A mesh is hit if one of its triangles is. If not, a crossing in front of the camera decides before one behind it.</summary>
    private static Outcome ClassifyMesh(Mesh mesh, Ray ray, out double t, out int? triangle)
    {
        var along = new RaySpace<Scalar>(new Ray<Scalar>(ray.Origin, ray.Direction));
        var refusal = Outcome.Misses;
        var (closest, nearest) = (double.NegativeInfinity, double.PositiveInfinity);
        int? refused = null, shown = null;
        var hit = mesh.Tree.Nearest(ray.Origin, ray.Direction, i =>
        {
            double crossing = mesh[i].Intersect(along).Near;
            var outcome = Outcomes.Classify(crossing, ray);
            if (outcome == Outcome.Shows)
            {
                if (crossing < nearest || (crossing == nearest && i < shown)) (nearest, shown) = (crossing, i);
                return crossing;
            }
            var isCloser = refusal == Outcome.BeyondFar ? outcome == Outcome.BeyondFar && crossing < closest : crossing > closest;
            if (outcome != Outcome.Misses && isCloser) (refusal, closest, refused) = (outcome, crossing, i);
            return null;
        });
        (t, triangle) = hit is null ? (refused is null ? double.NaN : closest, refused) : (hit.Value, shown);
        return hit is null ? refusal : Outcome.Shows;
    }

    /// <summary>A model without a formula returns only its hit. So it is tried again without clip planes, then in the opposite
    /// direction.</summary>
    private static Outcome JudgeByHits(Model model, Ray ray, out double t)
    {
        if (model.Intersect(ray) is { } hit)
        {
            t = hit;
            return hit < double.PositiveInfinity ? Outcome.Shows : Outcome.Misses;
        }
        t = model.Intersect(new Ray(ray.Origin, ray.Direction)) ?? double.NaN;
        if (double.IsFinite(t)) return Outcomes.Classify(t, ray) is var refusal and not Outcome.Shows ? refusal : Outcome.Misses;
        t = -(model.Intersect(new Ray(ray.Origin, -ray.Direction)) ?? double.NaN);
        return double.IsFinite(t) ? Outcome.Behind : Outcome.Misses;
    }
}
