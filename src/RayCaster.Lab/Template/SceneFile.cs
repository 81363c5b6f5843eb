using RayCaster;

namespace Lab;

/// <summary>Turns what the library has read from a scene file into the lab's own classes. You need not read this.</summary>
public static class SceneFile
{
    /// <summary>The same scene. A mesh becomes its triangles.</summary>
    public static Scene Of(RayCaster.Scene from)
    {
        var view = from.Camera;
        var camera = new Camera(Of(view.Position), Of(view.Target), Of(view.Up), view.FovY, view.Width, view.Height)
        {
            ZNear = view.ZNear,
            ZFar = view.ZFar,
            Bias = view.Bias,
            ClipsByDistance = view.Clip == ClipMode.Distance,
            SampleOffset = view.Sample == PixelSample.Center ? 0.5 : 0,
        };
        var scene = new Scene(camera, Of(from.Background));
        foreach (var model in from.Models)
            foreach (var part in PartsOf(model))
            {
                part.Color = Of(model.Color);
                scene.Models.Add(part);
            }
        return scene;
    }

    /// <summary>A model of the library as one of the lab; a mesh as many.</summary>
    public static IEnumerable<Model> PartsOf(RayCaster.Model model) => model switch
    {
        Model<RayCaster.Plane> { Primitive: var p } => [new Plane(Of(p.Point), Of(p.Normal))],
        Model<RayCaster.Sphere> { Primitive: var s } => [new Sphere(Of(s.Center), s.Radius)],
        Model<RayCaster.Aabb> { Primitive: var b } => [new Aabb(Of(b.Min), Of(b.Max))],
        Model<RayCaster.Circle> { Primitive: var c } => [new Circle(Of(c.Center), Of(c.Normal), c.Radius)],
        Model<RayCaster.Triangle> { Primitive: var t } => [Of(t)],
        Mesh mesh => Enumerable.Range(0, mesh.TriangleCount).Select(i => Of(mesh[i])),
        _ => throw new NotSupportedException($"the lab has no {model.GetType().Name}"),
    };

    private static Triangle Of(RayCaster.Triangle t) => new(Of(t.A), Of(t.B), Of(t.C));

    private static Vector3 Of(RayCaster.Vector3 v) => new(v.X, v.Y, v.Z);

    private static Color Of(RayCaster.Color c) => new(c.R, c.G, c.B);
}
