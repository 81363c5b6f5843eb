namespace RayCaster.Benchmarks;

/// <summary>Writes benchmark scenes for whole programs: as our scene files, as POV-Ray's, and meshes as PLY.</summary>
internal static class SceneFiles
{
    /// <summary>A scene file; a mesh stands in a PLY beside it.</summary>
    public static void WriteScene(string path, Scene scene, MeshData? mesh)
    {
        using var writer = new StreamWriter(path);
        var camera = scene.Camera;
        writer.WriteLine(Line($"{{ \"camera\": {{ \"position\": {camera.Position}, \"target\": {camera.Target}, \"up\": {camera.Up},"));
        writer.WriteLine(Line($"    \"fovY\": {camera.FovY:R}, \"zNear\": {camera.ZNear:R}, \"zFar\": {camera.ZFar:R} }},"));
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

    /// <summary>The same picture by POV-Ray: no lights, the attenuation as a pattern about the camera, rays through pixels' corners.</summary>
    public static void WritePov(string path, Scene scene, MeshData? mesh)
    {
        using var writer = new StreamWriter(path);
        var camera = scene.Camera;
        var right = camera.PlaneWidth * camera.U;
        var up = camera.PlaneHeight * camera.V;
        var direction = -camera.W - 0.5 / camera.Width * right - 0.5 / camera.Height * up;
        writer.WriteLine("#version 3.7;\nglobal_settings { assumed_gamma 1 ambient_light rgb 1 }");
        writer.WriteLine($"background {{ rgb {Angled(Vector(scene.Background))} }}");
        writer.WriteLine("camera " +
            $"{{ perspective location {Angled(camera.Position)} direction {Angled(direction)} right {Angled(right)} up {Angled(up)} }}");
        foreach (var model in scene.Models)
        {
            var shape = model switch
            {
                Model<Plane> { Primitive: var p } => $"plane {{ {Angled(p.Normal.Normalized)}, 0 translate {Angled(p.Point)}",
                Model<Sphere> { Primitive: var s } => Line($"sphere {{ {Angled(s.Center)}, {s.Radius:R}"),
                Model<Aabb> { Primitive: var b } => $"box {{ {Angled(b.Min)}, {Angled(b.Max)}",
                Model<Circle> { Primitive: var c } => Line($"disc {{ {Angled(c.Center)}, {Angled(c.Normal)}, {c.Radius:R}"),
                Model<Triangle> { Primitive: var t } => $"triangle {{ {Angled(t.A)}, {Angled(t.B)}, {Angled(t.C)}",
                _ => "mesh2 {",
            };
            writer.Write(shape);
            if (model is Mesh)
            {
                writer.WriteLine($" vertex_vectors {{ {mesh!.Vertices.Length}");
                foreach (var v in mesh.Vertices) writer.WriteLine("," + Angled(v));
                writer.WriteLine($"}} face_indices {{ {mesh.Indices.Length / 3}");
                for (var i = 0; i < mesh.Indices.Length; i += 3)
                    writer.WriteLine($",<{mesh.Indices[i]}, {mesh.Indices[i + 1]}, {mesh.Indices[i + 2]}>");
                writer.WriteLine("}");
            }
            writer.WriteLine(Line($" pigment {{ spherical color_map {{ [0 rgb 0] [1 rgb {Angled(Vector(model.Color))}] }} ") +
                Line($"scale {camera.FadeDistance:R} ") +
                $"translate {Angled(camera.Position)} }} finish {{ ambient 1 diffuse 0 }} }}");
        }
    }

    private static Vector3 Vector(Color color) => new(color.R, color.G, color.B);

    private static string Angled(Vector3 v) => $"<{v.ToString()[1..^1]}>";

    private static string Line(FormattableString text) => FormattableString.Invariant(text);
}
