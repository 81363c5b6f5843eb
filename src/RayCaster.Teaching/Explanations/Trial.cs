namespace RayCaster.Teaching;

/// <summary>The crossings of one model with a ray, in plain doubles. Quick enough to choose from thousands of models.</summary>
/// <param name="Hit">The t of the first crossing that counts, or null.</param>
/// <param name="Near">The first crossing; NaN for none.</param>
/// <param name="Outcome">Why it is not hit, for the crossing that comes closer to counting; <see cref="Outcome.Shows"/> for a hit.</param>
/// <param name="Mesh">What becomes of a mesh's triangles; null for other shapes.</param>
internal sealed record Trial(Model Model, int Index, double? Hit, double Near, double Far, Outcome Outcome, MeshTrial? Mesh)
{
    /// <summary>What is explained: the model, or one triangle of a mesh; null where the ray crosses none.</summary>
    public Model? Shape => Model is not RayCaster.Mesh mesh ? Model : Mesh!.Triangle is { } triangle ? Model.Of(mesh[triangle]) : null;

    public static Trial Of(Model model, int index, Ray ray)
    {
        var (hit, mesh) = (model.Intersect(ray), model is Mesh triangles ? MeshTrial.Of(triangles, ray) : null);
        var (near, far) = mesh is not null ? (mesh.T, double.NaN)
            : model.Intersect(new Ray<Scalar>(ray.Origin, ray.Direction)) is { } crossings ? (crossings.Near.Value, crossings.Far.Value)
            // a model in plain doubles and ifs: without clipping it returns where it would be hit
            : (hit ?? model.Intersect(new Ray(ray.Origin, ray.Direction)) ?? double.NaN, double.NaN);
        return new(model, index, hit, near, far, hit is null ? Outcomes.Of(double.IsFinite(far) ? far : near, ray) : Outcome.Shows, mesh);
    }
}

/// <summary>The crossings of a mesh's triangles with a ray.</summary>
/// <param name="Triangle">The index of the nearest triangle that counts, else of the nearest one that does not; null for none.</param>
/// <param name="T">Where the ray crosses that triangle; NaN for none.</param>
internal sealed record MeshTrial(int? Triangle, double T, Tally Triangles)
{
    public static MeshTrial Of(Mesh mesh, Ray ray)
    {
        var tally = new Tally();
        var along = new AlongRay<Scalar>(new Ray<Scalar>(ray.Origin, ray.Direction));
        var (best, chosen) = ((IsRefused: true, Distance: double.PositiveInfinity), new MeshTrial(null, double.NaN, tally));
        for (var i = 0; i < mesh.TriangleCount; i++)
        {
            double t = mesh[i].Intersect(along).Near;
            var outcome = Outcomes.Of(t, ray);
            tally[outcome]++;
            var rank = (outcome != Outcome.Shows, Math.Abs(t));
            if (!outcome.IsMiss() && rank.CompareTo(best) < 0) (best, chosen) = (rank, chosen with { Triangle = i, T = t });
        }
        return chosen;
    }
}
