using RayCaster.Testing.Fuzzing;

namespace RayCaster.Testing;

/// <summary>Random things, the same in every run because the caller seeds the generator.</summary>
internal static class Some
{
    /// <summary>Random numbers that are the same in each run, and others for each value of RAYCASTER_SEED.</summary>
    /// <param name="number">Other numbers for each.</param>
    public static Random Chance(int number) => new(unchecked((int)((Campaign.Seed - 1) * 1_000_003L + number)));

    /// <summary>A number between −reach and reach.</summary>
    public static double Number(Random random, double reach) => reach * (2 * random.NextDouble() - 1);

    /// <summary>A multiple of 1/16 between −16 and 16: sums and differences of such numbers are exact.</summary>
    public static double Sixteenth(Random random) => random.Next(-256, 257) / 16.0;

    public static Vector3 Point(Random random, double reach) => new(Number(random, reach), Number(random, reach), Number(random, reach));

    public static Vector3 GridPoint(Random random) => new(Sixteenth(random), Sixteenth(random), Sixteenth(random));

    /// <summary>The box between two of its corners.</summary>
    public static Aabb Box(Vector3 a, Vector3 b) => new(
        new(Math.Min(a.X, b.X), Math.Min(a.Y, b.Y), Math.Min(a.Z, b.Z)), new(Math.Max(a.X, b.X), Math.Max(a.Y, b.Y), Math.Max(a.Z, b.Z)));

    /// <summary>The shapes with a formula: the triangles of a mesh, or the model itself.</summary>
    public static IEnumerable<Model> ShapesOf(Model model) =>
        model is Mesh mesh ? Enumerable.Range(0, mesh.TriangleCount).Select(i => Model.Of(mesh[i])) : [model];

    /// <summary>One of some random scenes, if possible one in which more than one model, or a model and the background, shows.</summary>
    public static Scene SceneThatShows(Random random, Func<Random, Scene> make)
    {
        var scene = make(random);
        for (var attempt = 0; attempt < 6 && !ShowsTwo(scene); attempt++) scene = make(random);
        return scene;
    }

    private static bool ShowsTwo(Scene scene)
    {
        const int Side = 8;
        var (width, height) = (scene.Camera.Width, scene.Camera.Height);
        var shown = Enumerable.Range(0, Side * Side)
            .Select(i => ScalarRenderer.Cast(scene, i % Side * width / Side, i / Side * height / Side).Model);
        return shown.Distinct().Skip(1).Any();
    }

    /// <summary>Turns a picture upside down.</summary>
    public static void Flip(Picture picture) =>
        picture.Rgb.Chunk(3 * picture.Width).Reverse().SelectMany(line => line).ToArray().CopyTo(picture.Rgb, 0);

    /// <summary>A direction of length 1.</summary>
    public static Vector3 Direction(Random random)
    {
        while (true)
        {
            var v = Point(random, 1);
            if (v.Length is > 0.01 and < 1) return v.Normalized;
        }
    }
}
