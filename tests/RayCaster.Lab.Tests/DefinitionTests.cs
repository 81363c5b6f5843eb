using RayCaster;
using RayCaster.Files;
using RayCaster.Teaching;
using RayCaster.Teaching.Comparison;

namespace Lab.Tests;

/// <summary>The lab, which shares no formula with the library, and the library's definition of a picture agree.</summary>
public class DefinitionTests
{
    private static readonly string Folder = ProjectFolder.PathOf("scenes");

    public static TheoryData<string> Scenes =>
    [
        .. Directory.EnumerateFiles(Folder, "*.json", SearchOption.AllDirectories)
            .Where(file => !file.EndsWith(".schema.json") && !ProjectFolder.IsOwnScene(file))
            .Select(file => Path.GetRelativePath(Folder, file)).Order(StringComparer.Ordinal),
    ];

    [Theory]
    [MemberData(nameof(Scenes))]
    public void ThePictureIsTheDefinitions(string name)
    {
        var scene = SceneReader.Read(Path.Combine(Folder, name)).Scene;
        var divisor = scene.Models.Any(model => model is Mesh) ? 25 : 3; // each pixel's ray is tested against thousands of triangles, twice
        scene = scene.WithSize(scene.Camera.Width / divisor, scene.Camera.Height / divisor);
        var difference = new PictureDifference(SceneFile.Of(scene).Draw(), ScalarRenderer.Render(scene));
        // Other formulas for the same t: their last bits may turn a pixel on an outline, or round a channel the other way.
        Assert.True(difference.CountBeyond(0) <= 3, $"{name}: the lab (src/RayCaster.Lab) and the library (src/RayCaster) draw " +
            $"{difference.CountBeyond(0)} pixels differently, {difference.Wrong} by more than a level");
    }

    [Fact]
    public void TheBodiesOfAStepAreThoseThatTheHandOutOpensWithIt() =>
        Assert.All(Todo.Bodies, body => Assert.Equal(body.Step, Slides.StepOf(body.Slide)));

    [Fact]
    public void NothingIsLeftToDo() => Assert.Equal("", Todo.Report());
}
