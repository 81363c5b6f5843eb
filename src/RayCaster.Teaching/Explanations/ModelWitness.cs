namespace RayCaster.Teaching;

/// <summary>Finds what becomes of rays, for one model.</summary>
/// <param name="origin">Where all rays start.</param>
internal sealed class ModelWitness(Model model, Vector3 origin)
{
    private const int TrianglesOfBlock = 32;

    /// <summary>For a mesh, the bounds of groups of triangles, seen from the origin: most rays miss most groups.</summary>
    private readonly Bounds[] blocks = model is Mesh mesh ? BlocksOf(mesh, origin) : [];

    /// <summary>How many formulas or tests of bounds one ray needs.</summary>
    public int Cost => Math.Max(1, blocks.Length);

    /// <param name="t">The t that counts, else that of a crossing that does not; NaN if there is none.</param>
    /// <returns><see cref="Outcome.Shows"/> for a hit, whatever else is in the scene.</returns>
    public Outcome Judge(Ray ray, out double t) =>
        blocks.Length > 0 ? JudgeMesh(ray, out t)
        : model.Intersect(new Ray<Scalar>(ray.Origin, ray.Direction)) is { } crossings ? JudgeShape(ray, crossings, out t)
        : JudgeByAsking(ray, out t);

    private Outcome JudgeShape(Ray ray, Crossings<Scalar> crossings, out double t)
    {
        t = ray.Clip.First(crossings, (Scalar)ray.ZPerT);
        if (!double.IsNaN(t)) return Outcome.Shows;

        // The far crossing is nearer to counting: if only the near one were too near, the far one would count.
        t = double.IsFinite(crossings.Far) ? crossings.Far : crossings.Near;
        if (double.IsFinite(t)) return Outcomes.Of(t, ray);
        var witness = model.Intersect(new Ray<Witness>(ray.Origin, ray.Direction))!.Value.Near.Loss;
        return witness == Outcome.Shows ? Outcome.NoNumber : witness;
    }

    /// <summary>A mesh is hit if one of its triangles is. If not, a crossing in front of the camera decides before one behind it.</summary>
    private Outcome JudgeMesh(Ray ray, out double t)
    {
        var along = new AlongRay<Scalar>(new Ray<Scalar>(ray.Origin, ray.Direction));
        var (outcome, nearest) = (Outcome.PassesBy, double.NaN);
        for (var block = 0; block < blocks.Length; block++)
        {
            if (!Crosses(blocks[block], ray.Direction)) continue;
            var end = Math.Min(((Mesh)model).TriangleCount, (block + 1) * TrianglesOfBlock);
            for (var part = block * TrianglesOfBlock; part < end; part++)
            {
                double crossing = ((Mesh)model)[part].Intersect(along).Near;
                if (!double.IsFinite(crossing)) continue;
                var other = Outcomes.Of(crossing, ray);
                if (outcome == Outcome.Shows ? other != Outcome.Shows || crossing >= nearest
                    : other != Outcome.Shows && outcome != Outcome.PassesBy && crossing <= nearest) continue;
                (outcome, nearest) = (other, crossing);
            }
        }
        t = nearest;
        return outcome;
    }

    /// <summary>A model without a formula returns only its hit. So it is tried again without clip planes, then in the opposite
    /// direction.</summary>
    private Outcome JudgeByAsking(Ray ray, out double t)
    {
        t = model.Intersect(ray) ?? double.NegativeInfinity;
        if (ray.Counts(t)) return Outcome.Shows;
        if (double.IsNaN(t) || double.IsPositiveInfinity(t)) return Outcome.NoNumber;
        t = model.Intersect(new Ray(ray.Origin, ray.Direction)) ?? double.NaN;
        if (double.IsFinite(t)) return Outcomes.Of(t, ray);
        t = -(model.Intersect(new Ray(ray.Origin, -ray.Direction)) ?? double.NaN);
        return double.IsFinite(t) ? Outcome.Behind : Outcome.PassesBy;
    }

    private static Bounds[] BlocksOf(Mesh mesh, Vector3 origin)
    {
        var blocks = new Bounds[(mesh.TriangleCount + TrianglesOfBlock - 1) / TrianglesOfBlock];
        Array.Fill(blocks, Bounds.Empty);
        for (var i = 0; i < mesh.TriangleCount; i++) blocks[i / TrianglesOfBlock] = blocks[i / TrianglesOfBlock].With(mesh[i].Bounds);
        return Array.ConvertAll(blocks, bounds => bounds.PaddedFrom(origin));
    }

    /// <summary>Whether the line of a ray, on both sides of the camera, may cross padded bounds. NaN, from a line within a face, changes neither
    /// limit, so such bounds are kept.</summary>
    private static bool Crosses(in Bounds bounds, Vector3 d)
    {
        var (least, most) = (double.NegativeInfinity, double.PositiveInfinity);
        Slab(bounds.Min.X / d.X, bounds.Max.X / d.X, ref least, ref most);
        Slab(bounds.Min.Y / d.Y, bounds.Max.Y / d.Y, ref least, ref most);
        Slab(bounds.Min.Z / d.Z, bounds.Max.Z / d.Z, ref least, ref most);
        return least <= most;

        static void Slab(double t0, double t1, ref double least, ref double most)
        {
            if (t0 > t1) (t0, t1) = (t1, t0);
            if (t0 > least) least = t0;
            if (t1 < most) most = t1;
        }
    }
}
