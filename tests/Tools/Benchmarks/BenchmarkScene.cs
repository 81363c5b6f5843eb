using System.Globalization;

namespace RayCaster.Benchmarks;

/// <summary>A scene to measure. Its models are made again for each run, so that nothing prepared for one picture helps the next.</summary>
/// <param name="name">What options and tables call it.</param>
/// <param name="title">What it shows.</param>
/// <param name="create">Makes it in a size.</param>
internal sealed class BenchmarkScene(string name, string title, Func<int, int, Scene> create)
{
    /// <summary>The scenes of the tables.</summary>
    public static readonly string[] Names = ["room", "bumpy-70k", "bumpy-1m", "bumpy-10m", "spheres-100k"];

    public string Name { get; } = name;

    public string Title { get; } = title;

    /// <summary>The scene's mesh, if it is one: what a mesh file of it holds.</summary>
    public MeshData? Mesh { get; private init; }

    /// <summary>The scene with new models.</summary>
    public Scene Create(int width, int height) => create(width, height);

    /// <summary>A scene by its name: room, or bumpy-N, spheres-N and a number, as in 500, 70k or 10m.</summary>
    /// <exception cref="ArgumentException">The name is another.</exception>
    public static BenchmarkScene Named(string name)
    {
        if (name == "room") return Room();
        if (name.Split('-') is [var kind, { Length: > 0 } number])
        {
            var (digits, unit) = number[^1] switch { 'k' => (number[..^1], 1000), 'm' => (number[..^1], 1_000_000), _ => (number, 1) };
            if (int.TryParse(digits, NumberStyles.None, CultureInfo.InvariantCulture, out var value) && value is > 0 and <= 1_000_000_000)
            {
                var count = checked(value * unit);
                if (kind == "bumpy") return Bumpy(name, BandsFor(count));
                if (kind == "spheres") return Spheres(name, count);
            }
        }
        throw new ArgumentException($"no scene is called '{name}'; choose {string.Join(", ", Names)}, or another number");
    }

    /// <summary>The room of the course: the project's scenes/room.json.</summary>
    private static BenchmarkScene Room()
    {
        var scene = SceneReader.Read(ProjectFolder.PathOf("scenes/room.json")).Scene!;
        return new("room", "the course's room", (width, height) => scene.WithSize(width, height));
    }

    /// <summary>
    /// A sphere with bumps, of 4 m (m − 1) triangles: m bands from pole to pole and 2 m around, at polar angle a and longitude b the
    /// radius is 1 + 0.1 sin 8a sin 9b + 0.01 sin 40a sin 45b. Corners are rounded to float, so that all peers see the same.
    /// </summary>
    private static MeshData BumpyMesh(int m)
    {
        var around = 2 * m;
        var vertices = new Vector3[2 + (m - 1) * around];
        vertices[0] = new(0, 0, 1);
        vertices[^1] = new(0, 0, -1);
        for (var band = 1; band < m; band++)
        {
            for (var i = 0; i < around; i++)
            {
                var (a, b) = (Math.PI * band / m, 2 * Math.PI * i / around);
                var r = 1 + 0.1 * Math.Sin(8 * a) * Math.Sin(9 * b) + 0.01 * Math.Sin(40 * a) * Math.Sin(45 * b);
                vertices[1 + (band - 1) * around + i] =
                    new((float)(r * Math.Sin(a) * Math.Cos(b)), (float)(r * Math.Sin(a) * Math.Sin(b)), (float)(r * Math.Cos(a)));
            }
        }

        var indices = new int[3 * 4 * m * (m - 1)];
        var n = 0;
        void Add(int a, int b, int c) => (indices[n++], indices[n++], indices[n++]) = (a, b, c);
        int At(int band, int i) => band == 0 ? 0 : band == m ? vertices.Length - 1 : 1 + (band - 1) * around + i % around;
        for (var band = 0; band < m; band++)
        {
            for (var i = 0; i < around; i++)
            {
                if (band < m - 1) Add(At(band, i), At(band + 1, i), At(band + 1, i + 1));
                if (band > 0) Add(At(band, i), At(band + 1, i + 1), At(band, i + 1));
            }
        }
        return new(vertices, indices);
    }

    /// <summary>The scene of <see cref="BumpyMesh"/>.</summary>
    private static BenchmarkScene Bumpy(string name, int m)
    {
        var mesh = BumpyMesh(m);
        return new(name, $"a bumpy sphere of {mesh.Indices.Length / 3:N0} triangles", (width, height) => new(CameraAt(width, height),
            [new Mesh(mesh.Vertices, mesh.Indices) { Color = new(0.9, 0.8, 0.6) }], new Color(0.1, 0.1, 0.2))) { Mesh = mesh };
    }

    /// <summary>The number of bands with which <see cref="BumpyMesh"/> has about so many triangles.</summary>
    private static int BandsFor(int count) => Math.Max(2, (int)((1 + Math.Sqrt(1 + count)) / 2));

    /// <summary>Spheres in a cube of side 2, with radii from a quarter to a half of the side that each has for itself; seeded.</summary>
    private static BenchmarkScene Spheres(string name, int count)
    {
        var random = new Random(20240607);
        var side = 2 / Math.Cbrt(count);
        double Next(double from, double to) => (float)(from + (to - from) * random.NextDouble());
        var spheres = new (Sphere Sphere, Color Color)[count];
        for (var i = 0; i < count; i++)
        {
            spheres[i] = (new(new(Next(-1, 1), Next(-1, 1), Next(-1, 1)), Next(side / 4, side / 2)),
                new(Next(0.2, 1), Next(0.2, 1), Next(0.2, 1)));
        }
        return new(name, $"{count:N0} spheres", (width, height) =>
        {
            var models = new Model[count];
            for (var i = 0; i < count; i++)
            {
                models[i] = Model.Of(spheres[i].Sphere);
                models[i].Color = spheres[i].Color;
            }
            return new(CameraAt(width, height), models, new Color(0.1, 0.1, 0.2));
        });
    }

    /// <summary>A camera that a thing of radius 1.1 about the origin fills from top to bottom.</summary>
    private static Camera CameraAt(int width, int height) =>
        new(new(2.2, 1.5, 1.2), new(0, 0, 0)) { Width = width, Height = height, ZNear = 0.125, ZFar = 128 };
}
