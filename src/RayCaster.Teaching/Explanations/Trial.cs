namespace RayCaster.Teaching;

/// <summary>How one model fares with a ray, in plain doubles: enough to sort thousands of models by how much they have to do with a pixel.</summary>
internal readonly struct Trial
{
    /// <param name="model">The model.</param>
    /// <param name="index">Its place in the scene.</param>
    /// <param name="ray">The ray.</param>
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
        else // plain doubles and ifs: without clipping it tells where it would be hit
            (Near, Far) = (Hit ?? model.Intersect(new Ray(ray.Origin, ray.Direction)) ?? double.NaN, double.NaN);
        Refusal = Hit is null ? Reason(ray, Near, Far) : Refusal.None;
    }

    /// <summary>The model.</summary>
    public Model Model { get; }

    /// <summary>Its place in the scene.</summary>
    public int Index { get; }

    /// <summary>The t of the first crossing that counts, or null.</summary>
    public double? Hit { get; }

    /// <summary>The crossings; NaN for none.</summary>
    public double Near { get; }

    /// <inheritdoc cref="Near"/>
    public double Far { get; }

    /// <summary>Why it is not hit; of two crossings the one that comes closer to counting.</summary>
    public Refusal Refusal { get; }

    /// <summary>How a mesh's triangles fare.</summary>
    public MeshExplanation? Mesh { get; }

    /// <summary>A ray for a formula.</summary>
    public static Ray<Scalar> Plain(Ray ray) => new(ray.Origin, ray.Direction);

    private static Refusal Reason(Ray ray, double near, double far)
    {
        var first = ray.Clip.Refuse(near, ray.ZPerT);
        var second = ray.Clip.Refuse(far, ray.ZPerT);
        return second is Refusal.NoNumber || first is Refusal.BeyondFar ? first : second;
    }

    private static MeshExplanation TryTriangles(Mesh mesh, Ray ray, double? hit)
    {
        var counts = new int[(int)Refusal.BeyondFar + 1];
        var along = new AlongRay<Scalar>(Plain(ray));
        int? chosen = null;
        var nearest = double.PositiveInfinity; // of the refused, the one with the least |t|
        for (var i = 0; i < mesh.TriangleCount; i++)
        {
            double t = mesh[i].Intersect(along).Near;
            var refusal = ray.Clip.Refuse(t, ray.ZPerT);
            counts[(int)refusal]++;
            if (refusal is Refusal.NoNumber) continue;
            if (hit is null ? Math.Abs(t) < nearest : chosen is null && t == hit && refusal is Refusal.None) (chosen, nearest) = (i, Math.Abs(t));
        }
        return new(mesh.TriangleCount, chosen, counts[(int)Refusal.NoNumber], counts[(int)Refusal.Behind], counts[(int)Refusal.UnderBias],
            counts[(int)Refusal.BeforeNear], counts[(int)Refusal.BeyondFar], counts[(int)Refusal.None]);
    }
}
