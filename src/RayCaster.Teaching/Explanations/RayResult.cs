namespace RayCaster.Teaching.Explanations;

/// <summary>The result of a pixel's ray, for one model.</summary>
/// <param name="T">The t of the hit, else of the crossing that comes closest to counting; not finite if there is none.</param>
/// <param name="Triangles">The results of a mesh's triangles; null for other shapes.</param>
/// <param name="Triangle">The index of the nearest triangle that counts, else of the nearest one that does not; null for none.</param>
internal sealed record RayResult(Model Model, int Index, Outcome Outcome, double T, Tally? Triangles = null, int? Triangle = null)
{
    /// <summary>What is explained: the model, or one triangle of a mesh; null where the ray crosses none.</summary>
    public Model? Shape => Model is not Mesh mesh ? Model : Triangle is { } triangle ? Model.Of(mesh[triangle]) : null;

    /// <param name="nearest">The ray's nearest hit.</param>
    public static RayResult Create(Model model, int index, Ray ray, Hit nearest)
    {
        var result = model is Mesh mesh ? OfMesh(mesh, index, ray) : new(model, index, Judge(model, ray, out var t), t);
        return result.Outcome == Outcome.Shows && index != nearest.Model ? result with { Outcome = Outcome.Hidden } : result;
    }

    /// <summary>The result of a ray, for one model, whatever else is in the scene: <see cref="Outcome.Shows"/> for a hit. Quick enough for all
    /// rays of a picture, also where a mesh has many triangles.</summary>
    /// <param name="t">As <see cref="T"/>.</param>
    public static Outcome Judge(Model model, Ray ray, out double t) =>
        model is Mesh mesh ? JudgeMesh(mesh, ray, out t)
        : model.Intersect(new Ray<Scalar>(ray.Origin, ray.Direction)) is { } crossings ? JudgeShape(ray, crossings, out t)
        : JudgeByHits(model, ray, out t);

    private static RayResult OfMesh(Mesh mesh, int index, Ray ray)
    {
        var tally = new Tally();
        var along = new RaySpace<Scalar>(new Ray<Scalar>(ray.Origin, ray.Direction));
        var best = (IsRefused: true, Distance: double.PositiveInfinity);
        var chosen = new RayResult(mesh, index, Outcome.Misses, double.NaN, tally);
        for (var i = 0; i < mesh.TriangleCount; i++)
        {
            double t = mesh[i].Intersect(along).Near;
            var outcome = Outcomes.Judge(t, ray);
            tally[outcome]++;
            var rank = (outcome != Outcome.Shows, Math.Abs(t));
            if (outcome != Outcome.Misses && rank.CompareTo(best) < 0)
                (best, chosen) = (rank, chosen with { Outcome = outcome, T = t, Triangle = i });
        }
        return chosen;
    }

    private static Outcome JudgeShape(Ray ray, Crossings<Scalar> crossings, out double t)
    {
        t = ray.ClipRange.First(crossings, (Scalar)ray.DepthPerT);
        if (!double.IsNaN(t)) return Outcome.Shows;

        // The far crossing comes closer to counting, unless both are too far away.
        t = double.IsFinite(crossings.Far) && Outcomes.Judge(crossings.Near, ray) != Outcome.BeyondFar ? crossings.Far : crossings.Near;
        return Outcomes.Judge(t, ray);
    }

    /// <summary>A mesh is hit if one of its triangles is. If not, a crossing in front of the camera decides before one behind it.</summary>
    private static Outcome JudgeMesh(Mesh mesh, Ray ray, out double t)
    {
        var along = new RaySpace<Scalar>(new Ray<Scalar>(ray.Origin, ray.Direction));
        var refusal = Outcome.Misses;
        var closest = double.NegativeInfinity;
        var hit = mesh.Tree.Nearest(ray.Origin, ray.Direction, triangle =>
        {
            double crossing = mesh[triangle].Intersect(along).Near;
            var outcome = Outcomes.Judge(crossing, ray);
            if (outcome == Outcome.Shows) return crossing;
            var isCloser = refusal == Outcome.BeyondFar ? outcome == Outcome.BeyondFar && crossing < closest : crossing > closest;
            if (outcome != Outcome.Misses && isCloser) (refusal, closest) = (outcome, crossing);
            return null;
        });
        t = hit ?? closest;
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
        if (double.IsFinite(t)) return Outcomes.Judge(t, ray) is var refusal and not Outcome.Shows ? refusal : Outcome.Misses;
        t = -(model.Intersect(new Ray(ray.Origin, -ray.Direction)) ?? double.NaN);
        return double.IsFinite(t) ? Outcome.Behind : Outcome.Misses;
    }
}
