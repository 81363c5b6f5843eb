namespace RayCaster.Testing;

/// <summary>Seeded scenes of mixed models: ties, cameras inside of things and on their faces, clip planes that cut, meshes near and far.</summary>
internal static class RandomScene
{
    public static Scene Make(Random random) => Testing.Some.SceneThatShows(random, MakeAny);

    private static Scene MakeAny(Random random)
    {
        var position = Some(random, 12);
        var target = random.Next(4) == 0 ? new Vector3(position.X - 5, position.Y, position.Z) : Some(random, 4);
        if (target == position) target += new Vector3(1, 0, 0);
        var up = Math.Abs((target - position).Normalized.Z) > 0.99 ? new Vector3(0, 1, 0) : new Vector3(0, 0, 1);
        var zNear = random.Next(3) == 0 ? 4 * random.NextDouble() : 0;
        var camera = new Camera(position, target)
        {
            Up = up,
            FovY = 10 + 120 * random.NextDouble(),
            Width = random.Next(1, 90),
            Height = random.Next(1, 40),
            ZNear = zNear,
            ZFar = random.Next(3) == 0 ? zNear + 15 * random.NextDouble() : 1000,
            Bias = random.Next(2) * 1e-6,
            Clip = (ClipMode)random.Next(2),
            Sample = (PixelSample)random.Next(2),
        };

        var models = new List<Model>();
        for (var i = random.Next(0, 8); i >= 0; i--)
        {
            var model = MakeModel(random, position);
            model.Name = $"{models.Count} ({model.GetType().Name})";
            if (random.Next(2) == 0) model.Color = new(2 * random.NextDouble(), random.NextDouble(), random.Next(2));
            models.Add(model);
            if (random.Next(5) == 0) models.Add(model is Model<Plane> { Primitive: var plane } ? Model.Of(plane) : Model.Of(new Sphere(target, 1)));
        }
        return new Scene(camera, models, new Color(0.1, 0.2, 0.3));
    }

    private static Model MakeModel(Random random, Vector3 position)
    {
        switch (random.Next(7))
        {
            case 0: return Model.Of(new Plane(Some(random, 6), Some(random, 1) + new Vector3(0, 0, 0.01)));
            case 1: return Model.Of(new Sphere(random.Next(5) == 0 ? position : Some(random, 6), 0.3 + 4 * random.NextDouble()));
            case 2:
                return Model.Of(Testing.Some.Box(random.Next(5) == 0 ? position : Some(random, 6), Some(random, 6)));
            case 3: return Model.Of(new Circle(Some(random, 6), Some(random, 1) + new Vector3(0, 0, 0.01), 3 * random.NextDouble() + 0.1));
            case 4: return Model.Of(new Triangle(Some(random, 6), Some(random, 6), Some(random, 6)));
            case 5: return Lattice(random, random.Next(3) == 0 ? position : Some(random, 5), 0.5 + 4 * random.NextDouble());
            default:
                // A crowd of loose triangles, some of them many times in one place.
                var vertices = new Vector3[30];
                for (var i = 0; i < vertices.Length; i++) vertices[i] = Some(random, 8);
                var indices = new int[3 * random.Next(1, 60)];
                for (var i = 0; i < indices.Length; i++) indices[i] = random.Next(vertices.Length / (1 + i % 2));
                return new Mesh(vertices, indices);
        }
    }

    /// <summary>A closed, bumpy sphere of 2 · 2 · n² triangles, seen from inside where it is put around the camera.</summary>
    private static Mesh Lattice(Random random, Vector3 center, double radius)
    {
        var n = random.Next(3, 12);
        var vertices = new List<Vector3>();
        var indices = new List<int>();
        for (var i = 0; i <= n; i++)
        {
            for (var j = 0; j < 2 * n; j++)
            {
                var (theta, phi) = (Math.PI * i / n, Math.PI * j / n);
                var r = radius * (1 + 0.2 * Math.Sin(5 * theta) * Math.Cos(3 * phi));
                vertices.Add(center + r * new Vector3(Math.Sin(theta) * Math.Cos(phi), Math.Sin(theta) * Math.Sin(phi), Math.Cos(theta)));
                if (i == 0) continue;
                var (right, above) = (j == 2 * n - 1 ? -j : 1, -2 * n);
                var corner = i * 2 * n + j;
                indices.AddRange([corner, corner + right, corner + above, corner + right, corner + right + above, corner + above]);
            }
        }
        return new Mesh([.. vertices], [.. indices]);
    }

    /// <summary>A point with coordinates that are whole every now and then, so that rays meet faces and edges exactly.</summary>
    private static Vector3 Some(Random random, double range)
    {
        double Coordinate() => random.Next(3) == 0 ? random.Next(-(int)range, (int)range + 1) : range * (2 * random.NextDouble() - 1);
        return new(Coordinate(), Coordinate(), Coordinate());
    }
}
