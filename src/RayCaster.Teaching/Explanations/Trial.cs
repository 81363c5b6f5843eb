namespace RayCaster.Teaching;

/// <summary>What becomes of a pixel's ray, for one model.</summary>
/// <param name="T">The t of the hit, else of the crossing that comes closest to counting; not finite if there is none.</param>
/// <param name="Triangles">What becomes of a mesh's triangles; null for other shapes.</param>
/// <param name="Triangle">The index of the nearest triangle that counts, else of the nearest one that does not; null for none.</param>
internal sealed record Trial(Model Model, int Index, Outcome Outcome, double T, Tally? Triangles = null, int? Triangle = null)
{
    /// <summary>What is explained: the model, or one triangle of a mesh; null where the ray crosses none.</summary>
    public Model? Shape => Model is not Mesh mesh ? Model : Triangle is { } triangle ? Model.Of(mesh[triangle]) : null;

    /// <param name="ray">With its nearest hit.</param>
    public static Trial Of(Model model, int index, Ray ray)
    {
        var trial = model is Mesh mesh ? OfMesh(mesh, index, ray) : new(model, index, ModelWitness.Judge(model, ray, out var t), t);
        return trial.Outcome == Outcome.Shows && model != ray.HitModel ? trial with { Outcome = Outcome.Hidden } : trial;
    }

    private static Trial OfMesh(Mesh mesh, int index, Ray ray)
    {
        var tally = new Tally();
        var along = new AlongRay<Scalar>(new Ray<Scalar>(ray.Origin, ray.Direction));
        var (best, chosen) = ((IsRefused: true, Distance: double.PositiveInfinity), new Trial(mesh, index, Outcome.PassesBy, double.NaN, tally));
        for (var i = 0; i < mesh.TriangleCount; i++)
        {
            double t = mesh[i].Intersect(along).Near;
            var outcome = Outcomes.Of(t, ray);
            tally[outcome]++;
            var rank = (outcome != Outcome.Shows, Math.Abs(t));
            if (!outcome.IsMiss() && rank.CompareTo(best) < 0) (best, chosen) = (rank, chosen with { Outcome = outcome, T = t, Triangle = i });
        }
        return chosen;
    }
}
