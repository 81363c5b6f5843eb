namespace RayCaster.Benchmarks;

/// <summary>Writes benchmark scenes for whole programs: as scene files, and meshes as PLY.</summary>
internal static class SceneFiles
{
    /// <summary>A scene file; a mesh stands in a PLY beside it.</summary>
    public static void WriteScene(string path, BenchmarkScene benchmark)
    {
        var (scene, mesh) = (benchmark.Create(1920, 1080), benchmark.Mesh);
        using var writer = new StreamWriter(path);
        var camera = scene.Camera;
        writer.WriteLine(Line($"{{ \"camera\": {{ \"position\": {camera.Position}, \"target\": {camera.Target}, \"up\": {camera.Up},"));
        writer.WriteLine(Line($"    \"fovY\": {camera.FovY:R}, \"zNear\": {camera.ZNear:R}, \"zFar\": {camera.ZFar:R},"));
        writer.WriteLine(Line($"    \"width\": 1920, \"height\": 1080 }},"));
        writer.WriteLine(Line($"  \"background\": {Vector(scene.Background)}, \"models\": ["));
        for (var i = 0; i < scene.Models.Count; i++)
        {
            var shape = scene.Models[i] switch
            {
                Model<Plane> { Primitive: var p } => $"\"plane\", \"point\": {p.Point}, \"normal\": {p.Normal}",
                Model<Sphere> { Primitive: var s } => Line($"\"sphere\", \"center\": {s.Center}, \"radius\": {s.Radius:R}"),
                Model<Aabb> { Primitive: var b } => $"\"aabb\", \"min\": {b.Min}, \"max\": {b.Max}",
                Model<Circle> { Primitive: var c } => Line($"\"circle\", \"center\": {c.Center}, \"normal\": {c.Normal}, \"radius\": {c.Radius:R}"),
                Model<Triangle> { Primitive: var t } => $"\"triangle\", \"a\": {t.A}, \"b\": {t.B}, \"c\": {t.C}",
                Mesh => $"\"mesh\", \"file\": \"{Path.GetFileNameWithoutExtension(path)}.ply\"",
                var other => throw new NotSupportedException($"no scene file has a {other.GetType().Name}"),
            };
            writer.WriteLine($"    {{ \"type\": {shape}, \"color\": {Vector(scene.Models[i].Color)} }}{(i < scene.Models.Count - 1 ? "," : "")}");
        }
        writer.WriteLine("  ] }");
        if (mesh is not null) File.WriteAllBytes(Path.ChangeExtension(path, ".ply"), MeshWriter.PlyFloat(mesh));
    }

    private static Vector3 Vector(Color color) => new(color.R, color.G, color.B);

    private static string Line(FormattableString text) => FormattableString.Invariant(text);
}
