namespace RayCaster.Benchmarks;

/// <summary>A scene as the Embree peer reads it: little-endian, in float, the camera's axes worked out.</summary>
internal static class PeerScene
{
    public static void Write(string path, Scene scene)
    {
        using var writer = new BinaryWriter(new BufferedStream(File.Create(path), 1 << 20));
        void Float(double number) => writer.Write((float)number);
        void Vector(Vector3 v)
        {
            Float(v.X);
            Float(v.Y);
            Float(v.Z);
        }

        var camera = scene.Camera;
        foreach (var v in new[] { camera.Position, camera.U, camera.V, camera.W }) Vector(v);
        Vector(new(scene.Background.R, scene.Background.G, scene.Background.B));
        foreach (var number in new[] { camera.PlaneHeight, camera.ZNear, camera.ZFar, camera.Bias, camera.FadeDistance }) Float(number);
        writer.Write(camera.Width);
        writer.Write(camera.Height);
        writer.Write(camera.Clip == ClipMode.Distance ? 1 : 0);
        writer.Write(camera.Sample == PixelSample.Center ? 1 : 0);
        writer.Write(scene.Models.Count);
        foreach (var model in scene.Models)
        {
            switch (model)
            {
                case Model<Plane> { Primitive: var p }: Start(0); Vector(p.Point); Vector(p.Normal); break;
                case Model<Sphere> { Primitive: var s }: Start(1); Vector(s.Center); Float(s.Radius); break;
                case Model<Aabb> { Primitive: var b }: Start(2); Vector(b.Min); Vector(b.Max); break;
                case Model<Circle> { Primitive: var c }: Start(3); Vector(c.Center); Vector(c.Normal); Float(c.Radius); break;
                case Model<Triangle> { Primitive: var t }: Start(4); Vector(t.A); Vector(t.B); Vector(t.C); break;
                default: throw new NotSupportedException($"the peer has no {model.GetType().Name}");
                case Mesh: throw new NotSupportedException("a mesh is written from its data");
            }

            void Start(int type)
            {
                writer.Write(type);
                Vector(new(model.Color.R, model.Color.G, model.Color.B));
            }
        }
    }

    /// <summary>The same for a scene that is one mesh.</summary>
    public static void WriteMesh(string path, Scene scene, MeshData mesh)
    {
        Write(path, scene with { Models = [] });
        using var writer = new BinaryWriter(new BufferedStream(File.OpenWrite(path), 1 << 20));
        writer.Seek(-sizeof(int), SeekOrigin.End);
        writer.Write(1);
        writer.Write(5);
        var color = scene.Models[0].Color;
        foreach (var channel in new[] { color.R, color.G, color.B }) writer.Write((float)channel);
        writer.Write(mesh.Vertices.Length);
        writer.Write(mesh.Indices.Length / 3);
        foreach (var v in mesh.Vertices)
        {
            writer.Write((float)v.X);
            writer.Write((float)v.Y);
            writer.Write((float)v.Z);
        }
        foreach (var i in mesh.Indices) writer.Write(i);
    }
}
