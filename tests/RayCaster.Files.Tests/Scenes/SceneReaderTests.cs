using System.Text;

namespace RayCaster.Files.Tests.Scenes;

public class SceneReaderTests
{
    [Fact]
    public void WhatIsLeftOutIsAsTheCamerasOwnDefault()
    {
        var scene = Read("Good/smallest.json");

        Assert.Equal(new Camera(new(20, 0, 0), new(0, 0, 0)), scene.Camera);
        Assert.Equal(Color.Black, scene.Background);
    }

    [Fact]
    public void EveryKeyOfTheCameraIsRead()
    {
        var scene = Read("Good/everything.json");
        var camera = new Camera(new(20, 1, 2), new(0, 0.5, 0))
        {
            Up = new(0, 1, 0),
            FovY = 60,
            Width = 64,
            Height = 48,
            ZNear = 0.5,
            ZFar = 50,
            Bias = 0,
            Clip = ClipMode.Distance,
            Sample = PixelSample.Center,
        };

        Assert.Equal(camera, scene.Camera);
        Assert.Equal(new Color(1, 128 / 255.0, 0), scene.Background);
    }

    [Fact]
    public void EveryKeyOfTheModelsIsRead()
    {
        var models = Read("Good/everything.json").Models;

        Assert.Equal(new Plane(new(0, 0, -5), new(0, 0, 2)), ((Model<Plane>)models[0]).Primitive);
        Assert.Equal(new Sphere(new(1, 2, 3), 1.5), ((Model<Sphere>)models[1]).Primitive);
        Assert.Equal(new Aabb(new(-1, -1, 0), new(1, 1, 0)), ((Model<Aabb>)models[2]).Primitive);
        Assert.Equal(new Circle(new(0, 0, 1), new(1, 1, 1), 2), ((Model<Circle>)models[3]).Primitive);
        Assert.Equal(new Triangle(new(0, 0, 0), new(1, 0, 0), new(0, 1, 0)), ((Model<Triangle>)models[4]).Primitive);
        Assert.Equal(["floor", "ball", null, null, null, null, null], models.Select(model => model.Name));
        Assert.Equal([new(0.25, 0.5, 0.75), Color.White, new(0, 1, 127 / 255.0), new(3.5, 0, 0)], models.Take(4).Select(model => model.Color));
    }

    [Fact]
    public void AMeshIsScaledThenTurnedThenMoved()
    {
        var mesh = (Mesh)Read("Good/everything.json").Models[5];

        // Corners (0, 0, 0), (1, 0, 0), (0, 1, 0) times (1, -2, 3), a quarter turn about z, plus (5, 6, 7).
        Assert.Equal(new Triangle(new(5, 6, 7), new(5, 7, 7), new(7, 6, 7)), mesh[0]);
        Assert.Equal(4, mesh.TriangleCount);
    }

    [Fact]
    public void EscapesInTextsAreUndone() => Assert.Equal("🙂é \"\\", Read("Good/text-with-escapes.json").Models[0].Name);

    [Fact]
    public void HalfACharacterInAKeyIsShownAsWritten() => Assert.Equal(
        "\\ud83d is an unknown key; keys that can be added here: $schema, background",
        SceneReader.Parse("""{ "camera": null, "models": [], "\ud83d": 1 }"""u8.ToArray(), "x", ".").Problems[1].Message);

    [Fact]
    public void AMeshFileOfASceneFromStandardInputIsSoughtInTheGivenFolder()
    {
        var scene = File.ReadAllBytes(SceneFolders.InTests("Good/mesh-with-flat-triangles.json"));

        Assert.NotNull(SceneReader.Parse(scene, "<stdin>", SceneFolders.InTests("Good")).Scene);
        Assert.Null(SceneReader.Parse(scene, "<stdin>", SceneFolders.InTests("Broken")).Scene);
    }

    [Fact]
    public void AMistakeInAMeshFileIsReportedAtTheScenesLineThatNamesIt()
    {
        var scene = """
            { "camera": { "position": [9, 9, 9], "target": [0, 0, 0] }, "models": [
              { "type": "mesh", "file": "broken.obj" } ] }
            """u8;
        var folder = SceneFolders.InTests("Broken/Sense");
        var problem = Assert.Single(SceneReader.Parse(scene.ToArray(), "<stdin>", folder).Problems);

        Assert.StartsWith($"<stdin>(2,29): error: models[0].file: {Path.Combine(folder, "broken.obj")}(4): ", problem.ToString());
    }

    [Fact]
    public void AFileThatDoesNotExistHasNoLineButTheFullPathAndTheNearestName()
    {
        var full = SceneFolders.InTests("Good/everithing.json");
        var path = Path.GetRelativePath(Environment.CurrentDirectory, full);

        Assert.Equal($"{path}: error: file not found; looked for {Path.GetFullPath(full)}; did you mean \"everything.json\"?\n",
            SceneReader.Read(path).Report());
    }

    [Theory]
    [InlineData("Good/everything", "; did you mean \"everything.json\"?")]
    [InlineData("../../scenes/meshes/knot.ply", "knot.ply: error: this is a mesh; name it in a scene, and draw the scene")]
    [InlineData("Good", "Good: error: it is a folder, not a scene file")]
    public void WhatIsNoSceneIsNamed(string path, string message) =>
        Assert.EndsWith(message, Assert.Single(SceneReader.Read(SceneFolders.InTests(path)).Problems).ToString());

    [Fact]
    public void AShortFileIsReadUpToTheLimit()
    {
        using var folder = new TemporaryFolder();
        var path = folder.Write("rubric.json", new string(' ', SceneReader.MaxShortBytes + 1));
        Assert.Null(SceneReader.ReadShort(path, "the rubric", _ => "read", out var reading));
        Assert.Equal($"{path}: error: the file has more than 1,048,576 bytes, which is the limit\n", reading.Report());
    }

    [Fact]
    public void NestingOf64IsJsonAndNoMore()
    {
        static string Read(int depth) =>
            SceneReader.Parse(Encoding.UTF8.GetBytes(new string('[', depth) + new string(']', depth)), "x", ".").Problems[0].Message;

        Assert.Equal("the scene must be an object in braces { }, but is an array", Read(64));
        Assert.Equal("arrays and objects are nested deeper than 64", Read(65));
    }

    private static Scene Read(string scene) => SceneReader.Read(SceneFolders.InTests(scene)).Scene!;
}
