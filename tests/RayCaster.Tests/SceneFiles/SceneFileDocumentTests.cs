using System.Text;
using System.Text.RegularExpressions;

namespace RayCaster.Tests.SceneFiles;

/// <summary>docs/scene-file.md says what is so.</summary>
public class SceneFileDocumentTests
{
    private static readonly string Document = File.ReadAllText(Path.Combine(SceneFolders.Root, "docs/scene-file.md")).ReplaceLineEndings("\n");

    [Fact]
    public void TheExampleIsAGoodScene() => Assert.Equal("", Read(Blocks("json")[0]).Report());

    [Fact]
    public void TheMistakesAreReportedAsPrinted() => Assert.Equal(Blocks("text")[0], Read(Blocks("json")[1]).Report());

    [Fact]
    public void EveryKeyIsExplained()
    {
        SceneReader.ReadScene(SceneObject.Describing(out var scene));
        var keys = scene.Concat(scene.SelectMany(key => key.Members)).Select(key => key.Name);

        Assert.DoesNotContain(keys.Concat(PrimitiveList.KeysOfAllTypes()), key => !Document.Contains($"`{key}`"));
    }

    private static string[] Blocks(string language) =>
        [.. Regex.Matches(Document, $"```{language}\n(.*?)```", RegexOptions.Singleline).Select(block => block.Groups[1].Value)];

    private static SceneReading Read(string text) =>
        SceneReader.Parse(Encoding.UTF8.GetBytes(text), "room.json", Path.Combine(SceneFolders.Root, "scenes"));
}
