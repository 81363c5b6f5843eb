namespace RayCaster.Teaching;

/// <summary>Normals and surface parameters at a picture's hits.</summary>
internal sealed class SurfaceHits(Scene scene, HitMap hits)
{
    /// <summary>For a shape without a known normal, four rays beside the pixel's own are cast, at this distance in pixels.</summary>
    private const double Step = 1.0 / 64;

    private readonly Camera camera = scene.Camera;
    private readonly ISurface?[] surfaces = [.. scene.Models.Select(model => model.Surface)];

    /// <summary>The normal at a pixel's hit, of length 1 and towards the camera. Zero where nothing is hit, or where the shape has no known normal
    /// and a neighbouring ray misses it.</summary>
    /// <param name="column">c, from the left.</param>
    /// <param name="row">r, from the bottom.</param>
    public Vector3 Normal(int column, int row)
    {
        var place = PlaceOf(column, row);
        if (hits.Model[place] < 0) return Vector3.Zero;
        var d = Direction(column, row);
        var n = SurfaceAt(place, d) is { } surface ? surface.Normal(PointAt(place, d)) : FromNeighbours(column, row, hits.Model[place]);
        if (!double.IsFinite(n.Length) || n.Length == 0) return Vector3.Zero;
        n = n.Normalized;
        return n * d > 0 ? -n : n;
    }

    /// <summary>(u, v, 0) at a pixel's hit; zero where nothing is hit, or the shape has no parameters.</summary>
    /// <inheritdoc cref="Normal"/>
    public Vector3 Parameters(int column, int row)
    {
        var place = PlaceOf(column, row);
        var d = Direction(column, row);
        if (hits.Model[place] < 0 || SurfaceAt(place, d) is not { } surface) return Vector3.Zero;
        var (u, v) = surface.Parameters(PointAt(place, d));
        return new(u, v, 0);
    }

    private int PlaceOf(int column, int row) => (camera.Height - 1 - row) * camera.Width + column;

    private ISurface? SurfaceAt(int place, Vector3 d) =>
        scene.Models[hits.Model[place]] is Mesh mesh ? TriangleAt(mesh, hits.T[place], d) : surfaces[hits.Model[place]];

    /// <summary>The renderer says only which mesh is hit, and at which t: its triangle is the first whose formula gives that t to the bit.</summary>
    private Triangle TriangleAt(Mesh mesh, double t, Vector3 d)
    {
        var along = new AlongRay<Scalar>(new Ray<Scalar>(camera.Position, d));
        int? first = null;
        mesh.Tree.Nearest(camera.Position, d, triangle =>
        {
            if (mesh[triangle].Intersect(along).Near != t) return null;
            first = Math.Min(first ?? triangle, triangle);
            return t;
        });
        return mesh[first ?? 0];
    }

    private Vector3 PointAt(int place, Vector3 d) => camera.Position + hits.T[place] * d;

    private Vector3 Direction(double column, double row)
    {
        var d = camera.Direction<Scalar>(column, row);
        return new(d.X, d.Y, d.Z);
    }

    /// <summary>The cross product of two differences on the surface, between hits left and right and hits above and below. NaN where a ray
    /// misses.</summary>
    private Vector3 FromNeighbours(int column, int row, int model)
    {
        var across = Hit(column + Step, row, model) - Hit(column - Step, row, model);
        var upwards = Hit(column, row + Step, model) - Hit(column, row - Step, model);
        return across % upwards;
    }

    /// <summary>Where a ray hits a model, even if another model hides it there; NaN where it misses.</summary>
    private Vector3 Hit(double column, double row, int model)
    {
        var d = Direction(column, row);
        var ray = new Ray(camera.Position, d) { ClipRange = camera.ClipRange, ZPerT = camera.ZPerT<Scalar>(camera.Direction<Scalar>(column, row)) };
        return ray.At(scene.Models[model].Intersect(ray) ?? double.NaN);
    }
}
