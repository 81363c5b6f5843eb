namespace RayCaster.Teaching;

/// <summary>The crossings of one model with a ray, in plain doubles. Quick enough to choose from thousands of models.</summary>
internal readonly struct Trial
{
    public Trial(Model model, int index, Ray ray)
    {
        (Model, Index) = (model, index);
        Hit = model.Intersect(ray);
        if (model is RayCaster.Mesh mesh)
        {
            Mesh = TryTriangles(mesh, ray, Hit);
            Near = Far = double.NaN;
            if (Mesh.Triangle is { } part) (Near, Far) = (mesh[part].Intersect(Plain(ray)).Near, double.NaN);
        }
        else if (model.Intersect(Plain(ray)) is { } crossings)
            (Near, Far) = (crossings.Near, crossings.Far);
        else // a model in plain doubles and ifs: without clipping it returns where it would be hit
            (Near, Far) = (Hit ?? model.Intersect(new Ray(ray.Origin, ray.Direction)) ?? double.NaN, double.NaN);
        Outcome = Hit is null ? Outcomes.Of(double.IsFinite(Far) ? Far : Near, ray) : Outcome.Shows;
    }

    public Model Model { get; }

    public int Index { get; }

    /// <summary>The t of the first crossing that counts, or null.</summary>
    public double? Hit { get; }

    /// <summary>The crossings; NaN for none.</summary>
    public double Near { get; }

    public double Far { get; }

    /// <summary>Why it is not hit, for the crossing that comes closer to counting; <see cref="Outcome.Shows"/> for a hit.</summary>
    public Outcome Outcome { get; }

    /// <summary>The outcomes of a mesh's triangles; null for other shapes.</summary>
    public MeshExplanation? Mesh { get; }

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
