namespace RayCaster.Files.Tests.Scenes;

/// <summary>Rules for every scene of the project, because students learn from them.</summary>
public class SceneFolderTests
{
    public static TheoryData<string> Scenes =>
        [.. SceneFolder.Files("scenes").Concat(SceneFolder.Files("scenes/mistakes")).Concat(SceneFolder.Files("scenes/weeks"))
            .Select(SceneFolder.NameOf)];

    [Theory]
    [MemberData(nameof(Scenes))]
    public void BeginsWithTheSchemaAndWhatToSee(string name)
    {
        var lines = File.ReadAllLines(SceneFolder.FileOf(name));
        var schema = name.Contains('/') ? "../scene.schema.json" : "./scene.schema.json";
        Assert.Equal("{", lines[0]);
        Assert.Equal($"  \"$schema\": \"{schema}\",", lines[1]);
        Assert.StartsWith("  // ", lines[2]);
    }

    [Theory]
    [MemberData(nameof(Scenes))]
    public void IsAtMost640PixelsLong(string name)
    {
        var camera = SceneFolder.Read(SceneFolder.FileOf(name)).Camera;
        Assert.InRange(Math.Max(camera.Width, camera.Height), 1, 640);
    }
}
