namespace RayCaster.Teaching;

/// <summary>The crossings of one model with a ray, in plain doubles. Quick enough to choose from thousands of models.</summary>
/// <param name="Hit">The t of the first crossing that counts, or null.</param>
/// <param name="Near">The first crossing; NaN for none.</param>
/// <param name="Outcome">Why it is not hit, for the crossing that comes closer to counting; <see cref="Outcome.Shows"/> for a hit.</param>
/// <param name="Mesh">The outcomes of a mesh's triangles; null for other shapes.</param>
internal readonly record struct Trial(
    Model Model, int Index, double? Hit, double Near, double Far, Outcome Outcome, MeshExplanation? Mesh = null)
{
    public static Trial Of(Model model, int index, Ray ray)
    {
        var hit = model.Intersect(ray);
        if (model is Mesh mesh)
        {
            var tried = TryTriangles(mesh, ray, hit);
            return Of(tried.Triangle is { } part ? mesh[part].Intersect(Plain(ray)).Near : double.NaN, double.NaN) with { Mesh = tried };
        }
        return model.Intersect(Plain(ray)) is { } crossings ? Of(crossings.Near, crossings.Far)
            // a model in plain doubles and ifs: without clipping it returns where it would be hit
            : Of(hit ?? model.Intersect(new Ray(ray.Origin, ray.Direction)) ?? double.NaN, double.NaN);

        Trial Of(double near, double far) =>
            new(model, index, hit, near, far, hit is null ? Outcomes.Of(double.IsFinite(far) ? far : near, ray) : Outcome.Shows);
    }

    public static Ray<Scalar> Plain(Ray ray) => new(ray.Origin, ray.Direction);

    private static MeshExplanation TryTriangles(Mesh mesh, Ray ray, double? hit)
    {
        var counts = new int[Outcomes.Count];
        var along = new AlongRay<Scalar>(Plain(ray));
        int? chosen = null;
        var nearest = double.PositiveInfinity; // the least |t| of crossings that do not count
        for (var i = 0; i < mesh.TriangleCount; i++)
        {
            double t = mesh[i].Intersect(along).Near;
            var outcome = Outcomes.Of(t, ray);
            counts[(int)outcome]++;
            if (outcome.IsMiss()) continue;
            if (hit is null ? Math.Abs(t) < nearest : chosen is null && t == hit && outcome.Counts()) (chosen, nearest) = (i, Math.Abs(t));
        }
        return new(mesh.TriangleCount, chosen, counts[(int)Outcome.NoNumber], counts[(int)Outcome.Behind], counts[(int)Outcome.UnderBias],
            counts[(int)Outcome.BeforeNear], counts[(int)Outcome.BeyondFar], counts[(int)Outcome.Shows]);
    }
}
