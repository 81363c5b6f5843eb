using System.Globalization;
using System.Text;
using System.Text.RegularExpressions;

namespace RayCaster.Files.Tests.Parts;

public class SceneDigestTests
{
    private static readonly string Folder = ProjectFolder.PathOf("tests/RayCaster.Files.Tests/Good");
    private static readonly string Everything = File.ReadAllText(Path.Combine(Folder, "everything.json")).ReplaceLineEndings("\n");

    [Fact]
    public void EveryNumberChangesItInAWayOfItsOwn()
    {
        var digests = new HashSet<string> { DigestOf(Everything)! };
        var numbers = Regex.Matches(Everything, @"(?<=[\[ ])-?\d+(\.\d+)?(?=[,\] }])");
        Assert.Equal(63, numbers.Count);
        foreach (Match number in numbers)
        {
            var value = double.Parse(number.Value, CultureInfo.InvariantCulture);
            var digest = DigestOf(With(value + 1)) ?? DigestOf(With(value - 1)); // of two numbers in order one may not pass the other
            Assert.True(digest is not null && digests.Add(digest), $"{number.Value} at character {number.Index} does not count");

            string With(double other) => Everything[..number.Index] + other.ToString(CultureInfo.InvariantCulture)
                + Everything[(number.Index + number.Length)..];
        }
    }

    [Theory]
    [InlineData("\"distance\"", "\"depth\"")]
    [InlineData("\"center\"\n", "\"corner\"\n")]
    [InlineData("\"#ff8000\"", "\"#ff8001\"")]
    [InlineData("\"#00FF7f\"", "\"#00FE7f\"")]
    [InlineData("\"fovY\": 60", "\"fovY\": 60.00000000000001")]
    [InlineData("\"type\": \"mesh\", \"file\": \"./tetrahedron.obj\", \"scale\": 2,", "\"type\": \"sphere\", \"center\": [0, 0, 0], \"radius\": 2")]
    public void EveryWordAndTheLastBitChangeIt(string from, string to)
    {
        Assert.NotEqual(DigestOf(Everything), DigestOf(Everything.Replace(from, to)) ?? throw new InvalidDataException(from));
    }

    [Theory]
    [InlineData("// in any order", "/* at last */")]
    [InlineData("\"floor\"", "\"ground\"")]
    [InlineData("\"name\": \"ball\", ", "")]
    [InlineData("\"$schema\": \"../../../scenes/scene.schema.json\",", "")]
    [InlineData("[0.25, 0.5, 0.75]", "[ 2.5e-1,0.50,75e-2 ]")]
    [InlineData("\"fovY\": 60", "\"fovY\": 6e1")]
    [InlineData("\"#ff8000\"", "[1, 0.50196078431372548, 0]")]
    [InlineData("\"radius\": 1.5, \"center\": [1, 2, 3]", "\"center\": [1, 2, 3], \"radius\": 1.5")]
    [InlineData("\"radius\": 1.5", "\"radius\": 1.5, \"color\": [1, 1, 1]")]
    [InlineData("./tetrahedron.obj", "tetrahedron.obj")]
    [InlineData("\"rotate\": [0, 0, 90]", "\"rotate\": [0, 0, -270]")]
    public void HowItIsWrittenDoesNotChangeIt(string from, string to)
    {
        Assert.Contains(from, Everything);
        Assert.Equal(DigestOf(Everything), DigestOf(Everything.Replace(from, to)));
    }

    [Fact]
    public void TheOrderOfModelsCounts()
    {
        var scene = Read(Everything)!;
        Assert.NotEqual(Digest(scene), Digest(scene with { Models = [.. scene.Models.Reverse()] }));
    }

    [Theory]
    [InlineData("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", true)]
    [InlineData("# a comment\nv 0 0 0\nv 1.0 0 0 1\nvn 0 0 1\nv 0 1 0\nf 1//1 2//1 3//1\n", true)]
    [InlineData("v 0 0 0\nv 1 0 0\nv 0 1.0000000000000002 0\nf 1 2 3\n", false)]
    [InlineData("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 2 3 1\n", false)]
    public void OfAMeshFileTheTrianglesCount(string obj, bool isSame)
    {
        using var folder = new TemporaryFolder();
        folder.Write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        folder.Write("b.obj", obj);
        Assert.Equal(isSame, DigestOf("a.obj") == DigestOf("b.obj"));

        string DigestOf(string file) => Digest(SceneReader.Parse(Encoding.UTF8.GetBytes(
            "{ \"camera\": { \"position\": [5, 0, 0], \"target\": [0, 0, 0] }, \"models\": [ { \"type\": \"mesh\", \"file\": \"" + file +
                "\" } ] }"),
            "scene", folder.Path).Scene!);
    }

    [Fact]
    public void AShapeOrAClassOfOnesOwnCountsByItsNumbers()
    {
        var ring = new Ring(Vector3.Zero, new(0, 0, 1), 1, 2);
        Assert.NotEqual(DigestOf(Model.Of(ring)), DigestOf(Model.Of(new Ring(Vector3.Zero, new(0, 0, 1), 1, 3))));
        Assert.Equal(DigestOf(new Talkative(1)), DigestOf(new Talkative(1)));
        Assert.NotEqual(DigestOf(new Talkative(1)), DigestOf(new Talkative(2)));

        static string DigestOf(Model model) => Digest(new(new(new(5, 0, 0), Vector3.Zero), [model]));
    }

    [Fact]
    public void AClassThatKeepsItsNumbersToItselfIsRefused()
    {
        var scene = new Scene(new(new(5, 0, 0), Vector3.Zero), [Model.Of(new Sphere(Vector3.Zero, 1)), new Silent()]);
        Assert.Equal(
            "the scene cannot be drawn in parts: models[1] is of the class Silent, which does not say its numbers; "
            + "override ToString in it (docs/adding-a-primitive.md)",
            Assert.Throws<ProblemException>(() => Digest(scene)).Message);
    }

    private static string Digest(Scene scene) => SceneDigest.Compute(scene, SceneDigest.OfModels(scene.Models));

    private static string? DigestOf(string json) => Read(json) is { } scene ? Digest(scene) : null;

    private static Scene? Read(string json) => SceneReader.Parse(Encoding.UTF8.GetBytes(json), "scene", Folder).Scene;

    private sealed class Silent : Model
    {
        public override double? Intersect(Ray ray) => null;
    }

    private sealed class Talkative(double radius) : Model
    {
        public override double? Intersect(Ray ray) => null;

        public override string ToString() => $"talkative {radius:R}";
    }
}
