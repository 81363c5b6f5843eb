using System.Text;
using System.Text.RegularExpressions;

namespace RayCaster.Files.Tests.Scenes;

/// <summary>docs/scene-file.md agrees with the program.</summary>
public class SceneFileDocumentTests
{
    private static readonly string Document = File.ReadAllText(Path.Combine(SceneFolders.Root, "docs/scene-file.md")).ReplaceLineEndings("\n");

    [Fact]
    public void TheExampleIsAGoodScene() =>
        Assert.Equal("", Read(Regex.Match(Document, "```json\n(.*?)```", RegexOptions.Singleline).Groups[1].Value).Report());

    [Fact]
    public void EveryKeyOfSceneAndCameraIsExplained()
    {
        SceneReader.ReadScene(JsonKeys.Describing(out var scene));
        AssertExplained(scene.Concat(scene.SelectMany(key => key.Members)));
    }

    /// <summary>The types that come with the program; one that somebody adds need not be in the document.</summary>
    [Theory]
    [InlineData("plane")]
    [InlineData("sphere")]
    [InlineData("aabb")]
    [InlineData("circle")]
    [InlineData("triangle")]
    [InlineData("mesh")]
    public void EveryKeyOfABuiltInTypeIsExplained(string name)
    {
        Assert.Contains($"\n| `{name}` | ", Document);
        SceneReader.ReadModel(JsonKeys.Describing(out var keys), PrimitiveList.All.Single(type => type.Name == name));
        AssertExplained(keys);
    }

    private static void AssertExplained(IEnumerable<KeySpec> keys)
    {
        var missing = keys.Select(key => key.Name).Where(key => !Document.Contains($"`{key}`"));
        Assert.False(missing.Any(), $"docs/scene-file.md does not explain: {string.Join(", ", missing)}");
    }

    private static SceneReading Read(string text) =>
        SceneReader.Parse(Encoding.UTF8.GetBytes(text), "room.json", Path.Combine(SceneFolders.Root, "scenes/my"));
}
