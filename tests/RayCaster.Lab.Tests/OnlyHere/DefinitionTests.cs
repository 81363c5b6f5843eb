using RayCaster;
using RayCaster.Files;
using RayCaster.Teaching;

namespace Lab.Tests;

/// <summary>The lab, which shares no formula with the library, and the library's definition of a picture agree.</summary>
public class DefinitionTests
{
    private static readonly string Folder = FindScenes();

    public static TheoryData<string> Scenes =>
    [
        .. Directory.EnumerateFiles(Folder, "*.json").Concat(Directory.EnumerateFiles(Path.Combine(Folder, "mistakes"), "*.json"))
            .Where(file => !file.EndsWith(".schema.json")).Select(file => Path.GetRelativePath(Folder, file)).Order(StringComparer.Ordinal),
    ];

    [Theory]
    [MemberData(nameof(Scenes))]
    public void ThePictureIsTheDefinitions(string name)
    {
        var scene = SceneReader.Read(Path.Combine(Folder, name)).Scene;
        if (scene.Models.Any(model => model is Mesh)) // each pixel asks each of thousands of triangles, twice
            scene = scene with { Camera = scene.Camera.WithSize(scene.Camera.Width / 6, scene.Camera.Height / 6) };
        var difference = new PictureDifference(SceneFile.Of(scene).Draw(), ScalarRenderer.Render(scene));
        // Other formulas for the same t: their last bits may turn a pixel on an outline, or round a channel the other way.
        Assert.True(difference.CountBeyond(0) <= 3, $"{name}: {difference.CountBeyond(0)} pixels differ, {difference.Wrong} by more than a level");
    }

    private static string FindScenes()
    {
        var folder = new DirectoryInfo(AppContext.BaseDirectory);
        while (!File.Exists(Path.Combine(folder.FullName, "RayCaster.sln"))) folder = folder.Parent;
        return Path.Combine(folder.FullName, "scenes");
    }
}
