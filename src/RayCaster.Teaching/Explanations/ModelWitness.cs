namespace RayCaster.Teaching;

/// <summary>Finds what becomes of a ray, for one model.</summary>
internal static class ModelWitness
{
    /// <param name="t">The t of the hit, else of the crossing that comes closest to counting; not finite if there is none.</param>
    /// <returns><see cref="Outcome.Shows"/> for a hit, whatever else is in the scene.</returns>
    public static Outcome Judge(Model model, Ray ray, out double t) =>
        model is Mesh mesh ? JudgeMesh(mesh, ray, out t)
        : model.Intersect(new Ray<Scalar>(ray.Origin, ray.Direction)) is { } crossings ? JudgeShape(model, ray, crossings, out t)
        : JudgeByAsking(model, ray, out t);

    private static Outcome JudgeShape(Model model, Ray ray, Crossings<Scalar> crossings, out double t)
    {
        t = ray.ClipRange.First(crossings, (Scalar)ray.ZPerT);
        if (!double.IsNaN(t)) return Outcome.Shows;

        // The far crossing comes closer to counting, unless both are too far away.
        t = double.IsFinite(crossings.Far) && Outcomes.Of(crossings.Near, ray) != Outcome.BeyondFar ? crossings.Far : crossings.Near;
        if (double.IsFinite(t)) return Outcomes.Of(t, ray);
        var witness = model.Intersect(new Ray<Witness>(ray.Origin, ray.Direction))!.Value.Near.Loss;
        return witness == Outcome.Shows ? Outcome.NoNumber : witness;
    }

    /// <summary>A mesh is hit if one of its triangles is. If not, a crossing in front of the camera decides before one behind it.</summary>
    private static Outcome JudgeMesh(Mesh mesh, Ray ray, out double t)
    {
        var along = new AlongRay<Scalar>(new Ray<Scalar>(ray.Origin, ray.Direction));
        var (refusal, farthest) = (Outcome.PassesBy, double.NegativeInfinity);
        var hit = mesh.Tree.Nearest(ray.Origin, ray.Direction, triangle =>
        {
            double crossing = mesh[triangle].Intersect(along).Near;
            var outcome = Outcomes.Of(crossing, ray);
            if (outcome == Outcome.Shows) return crossing;
            if (!outcome.IsMiss() && crossing > farthest) (refusal, farthest) = (outcome, crossing);
            return null;
        });
        t = hit ?? farthest;
        return hit is null ? refusal : Outcome.Shows;
    }

    /// <summary>A model without a formula returns only its hit. So it is tried again without clip planes, then in the opposite
    /// direction.</summary>
    private static Outcome JudgeByAsking(Model model, Ray ray, out double t)
    {
        if (model.Intersect(ray) is { } hit)
        {
            t = hit;
            return hit < double.PositiveInfinity ? Outcome.Shows : Outcome.NoNumber;
        }
        t = model.Intersect(new Ray(ray.Origin, ray.Direction)) ?? double.NaN;
        if (double.IsFinite(t)) return Outcomes.Of(t, ray) is var refusal and not Outcome.Shows ? refusal : Outcome.NoNumber;
        t = -(model.Intersect(new Ray(ray.Origin, -ray.Direction)) ?? double.NaN);
        return double.IsFinite(t) ? Outcome.Behind : Outcome.PassesBy;
    }
}
