namespace RayCaster.Teaching;

/// <summary>A picture's hits, as the numbers of maps.</summary>
internal sealed class MapHits(Scene scene, HitMap hits)
{
    /// <summary>For a shape without a known normal, four rays beside the pixel's own are cast, at this distance in pixels.</summary>
    private const double Step = 1.0 / 64;

    private readonly Camera camera = scene.Camera;

    /// <summary>The number of a pixel, or three, as <see cref="MapKind"/> describes them.</summary>
    public Vector3 Numbers(MapKind kind, int x, int y)
    {
        var (t, model) = (hits.T[y * hits.Width + x], hits.Model[y * hits.Width + x]);
        return kind switch
        {
            MapKind.T => new(t, 0, 0),
            MapKind.Depth => new(t * -(Direction(x, y) * camera.W), 0, 0),
            MapKind.Model => new(model, 0, 0),
            _ when model < 0 => Vector3.Zero,
            MapKind.Normal => Normal(x, y, t, model),
            _ => Parameters(Direction(x, y), t, model),
        };
    }

    /// <summary>The normal, of length 1 and towards the camera; zero where the shape has no known normal and a neighbouring ray misses it.</summary>
    private Vector3 Normal(int x, int y, double t, int model)
    {
        var d = Direction(x, y);
        var n = (Surfaces.Normal(ShapeAt(d, t, model), camera.Position + t * d) ?? FromNeighbours(x, y, scene.Models[model])).Normalized;
        return n.Length > 0 ? n * d > 0 ? -n : n : Vector3.Zero; // else NaN
    }

    /// <summary>(u, v, 0); zero where the shape has no parameters.</summary>
    private Vector3 Parameters(Vector3 d, double t, int model)
    {
        var (u, v) = Surfaces.Parameters(ShapeAt(d, t, model), camera.Position + t * d);
        return new(u, v, 0);
    }

    /// <summary>A model, or the triangle of a mesh that is hit.</summary>
    private Model ShapeAt(Vector3 d, double t, int model) =>
        scene.Models[model] is Mesh mesh ? Model.Of(TriangleAt(mesh, t, d)) : scene.Models[model];

    /// <summary>The renderer says only which mesh is hit, and at which t: its triangle is the first whose formula gives that t to the bit.</summary>
    private Triangle TriangleAt(Mesh mesh, double t, Vector3 d)
    {
        var along = new RaySpace<Scalar>(new Ray<Scalar>(camera.Position, d));
        int? first = null;
        mesh.Tree.Nearest(camera.Position, d, triangle =>
        {
            if (mesh[triangle].Intersect(along).Near != t) return null;
            first = Math.Min(first ?? triangle, triangle);
            return t;
        });
        return mesh[first ?? 0];
    }

    /// <summary>The cross product of two differences on the surface, between hits right and left and hits above and below. NaN where a ray
    /// misses.</summary>
    private Vector3 FromNeighbours(int x, int y, Model model) =>
        (Hit(x + Step, y, model) - Hit(x - Step, y, model)) % (Hit(x, y - Step, model) - Hit(x, y + Step, model));

    /// <summary>Where a ray hits a model, even if another model hides it there; NaN where it misses.</summary>
    private Vector3 Hit(double x, double y, Model model)
    {
        var d = Direction(x, y);
        var ray = new Ray(camera.Position, d) { ClipRange = camera.ClipRange, DepthPerT = camera.DepthPerT<Scalar>((Vector3<Scalar>)d) };
        return ray.At(model.Intersect(ray) ?? double.NaN);
    }

    /// <param name="x">The column; with a fraction, beside the pixel's own ray.</param>
    private Vector3 Direction(double x, double y)
    {
        var d = camera.Direction<Scalar>(x, camera.Height - 1 - y);
        return new(d.X, d.Y, d.Z);
    }
}
