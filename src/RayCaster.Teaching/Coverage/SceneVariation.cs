using System.Security.Cryptography;
using System.Text.Json;

namespace RayCaster.Teaching.Coverage;

/// <summary>
/// Makes a similar scene with other numbers: each axis is stretched a little here and there, and radii change a little. Along an axis the order
/// stays, and equal coordinates stay equal. So a box still stands on its floor.
/// </summary>
public sealed class SceneVariation
{
    private const int MaxTries = 16;

    /// <summary>How far points move at most, as a share of the distance from camera to target. After some tries it is halved.</summary>
    private const double Amplitude = 0.035;

    /// <summary>How much a radius changes at most, as a share of it.</summary>
    private const double Growth = 0.08;

    private const int TriesPerAmplitude = 4;

    private static readonly string[] cameraPoints = ["position", "target"];
    private static readonly string[] modelPoints = ["point", "center", "min", "max", "a", "b", "c", "translate"];

    private readonly JsonTree tree;
    private readonly Axis[] axes;
    private readonly double growth;
    private readonly byte[] seed;
    private readonly int decimals;
    private readonly List<(JsonValue Value, string Text)> edits = [];

    private SceneVariation(JsonTree tree, double distance, string seed, double amplitude)
    {
        this.tree = tree;
        this.seed = SHA256.HashData(Encoding.UTF8.GetBytes(seed));
        axes = [.. ((int[])[0, 8, 16]).Select(at => Axis.Create(distance, amplitude, this.seed, at))];
        growth = Growth * amplitude / Amplitude;
        decimals = Math.Clamp(4 - (int)Math.Floor(Math.Log10(distance / 10)), 0, 15);
    }

    /// <summary>Varies a scene. Tries until the new scene shows every mistake that the old one shows in the catalogue's first variant.</summary>
    /// <param name="utf8">The text of a scene without errors.</param>
    /// <param name="folder">The folder where the paths of mesh files start.</param>
    /// <param name="seed">For example a student's name: the same seed gives the same scene.</param>
    /// <param name="newFolder">The folder of the new scene, from which its schema is found.</param>
    /// <param name="budget">How much is tried to find the scene's mistakes; those that are left out are not tried on the new one either. All are
    /// tried if it is left out.</param>
    /// <returns>The new text; null if no try succeeds.</returns>
    public static byte[]? Create(ReadOnlyMemory<byte> utf8, string folder, string seed, string newFolder, SearchBudget? budget = null)
    {
        if (SceneReader.Parse(utf8, "", folder).Scene is not { } scene) return null;
        if (JsonTree.Parse(new("", utf8, folder)) is not { } tree) return null;
        var shown = Shown(scene, budget);
        var distance = (scene.Camera.Target - scene.Camera.Position).Length;
        for (var attempt = 0; attempt < MaxTries; attempt++)
        {
            var amplitude = Amplitude / (1 << attempt / TriesPerAmplitude);
            var variation = new SceneVariation(tree, distance, $"{seed}\n{attempt}", amplitude);
            variation.MoveSchema(folder, newFolder);
            var text = variation.Text();
            if (SceneReader.Parse(text, "", folder) is { Scene: { } varied, Problems.Count: 0 } && Shows(varied, shown)) return text;
        }
        return null;
    }

    /// <summary>What the scene shows in each variant: a symmetric scene may owe what it shows only in some to the last bits.</summary>
    private static Mistake[] Shown(Scene scene, SearchBudget? budget)
    {
        if (!MutationCoverage.CanJudge(scene)) return [];
        var coverage = MutationCoverage.Measure([scene], budget: budget);
        return [.. coverage.Tested.Except([.. coverage.Hidden, .. coverage.SurvivorsInUsualForm, .. coverage.NotTried])];
    }

    private static bool Shows(Scene scene, Mistake[] mistakes) =>
        mistakes.Length == 0 || MutationCoverage.HiddenIn(scene, null, tested: mistakes).Hidden.Count == 0;

    private void MoveSchema(string folder, string newFolder)
    {
        if (tree.Root.Find("$schema") is not { Kind: JsonTokenType.String } schema || !File.Exists(Path.Combine(folder, schema.Text))) return;
        var path = Path.GetRelativePath(newFolder, Path.Combine(folder, schema.Text)).Replace('\\', '/');
        edits.Add((schema, $"\"{JsonEncodedText.Encode(path.StartsWith('.') ? path : "./" + path)}\""));
    }

    private byte[] Text()
    {
        if (tree.Root.Find("camera") is { } camera) Warp(camera, cameraPoints);
        foreach (var model in tree.Root.Find("models") is { } models ? models.Content : []) Warp(model, modelPoints);
        return tree.With(edits);
    }

    private void Warp(JsonValue o, string[] points)
    {
        foreach (var point in points)
        {
            if (o.Find(point) is not { Kind: JsonTokenType.StartArray } vector || vector.Content.ToArray() is not [var x, var y, var z]) continue;
            Replace(x, axes[0].Warp(x.Number));
            Replace(y, axes[1].Warp(y.Number));
            Replace(z, axes[2].Warp(z.Number));
        }
        if (o.Find("radius") is { Kind: JsonTokenType.Number } radius)
            Replace(radius, radius.Number * (1 + growth * Math.Sin(1e3 * radius.Number + seed[24])));
    }

    private void Replace(JsonValue number, double by) =>
        edits.Add((number, Math.Round(by, decimals).ToString("0.###############", CultureInfo.InvariantCulture)));

    /// <summary>The new coordinate is x + A sin(k x + φ). A k is less than 1, so it grows with x and the order stays.</summary>
    private readonly record struct Axis(double A, double K, double Phase)
    {
        public static Axis Create(double distance, double amplitude, byte[] seed, int at) => new(
            amplitude * distance,
            2 * Math.PI / (distance * (1 + seed[at] / 255.0)),
            2 * Math.PI * BitConverter.ToUInt16(seed, at + 2) / 65536);

        public double Warp(double x) => x + A * Math.Sin(K * x + Phase);
    }
}
