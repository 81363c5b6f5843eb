using System.Text.RegularExpressions;

namespace RayCaster.Files.Tests.Scenes;

public class BrokenSceneTests
{
    [Theory]
    [MemberData(nameof(SceneFolders.Scenes), "Broken/Encoding", MemberType = typeof(SceneFolders))]
    [MemberData(nameof(SceneFolders.Scenes), "Broken/Syntax", MemberType = typeof(SceneFolders))]
    [MemberData(nameof(SceneFolders.Scenes), "Broken/Shape", MemberType = typeof(SceneFolders))]
    [MemberData(nameof(SceneFolders.Scenes), "Broken/Sense", MemberType = typeof(SceneFolders))]
    public void ABrokenSceneIsRefusedWithTheseErrors(string scene)
    {
        var reading = SceneReader.Read(SceneFolders.InTests(scene));
        if (Here.IgnoresCase && scene.EndsWith("mesh-file-in-other-case.json"))
        {
            Assert.Empty(reading.Problems); // it is not broken there
            return;
        }

        Assert.Null(reading.Scene);
        Assert.Equal(Expected(scene), FirstLines(scene, reading));
    }

    [Theory]
    [MemberData(nameof(SceneFolders.Scenes), "Good", MemberType = typeof(SceneFolders))]
    public void AGoodSceneIsReadWithAtMostTheseWarnings(string scene)
    {
        var reading = SceneReader.Read(SceneFolders.InTests(scene));

        Assert.Equal(Expected(scene), FirstLines(scene, reading));
        Assert.NotNull(reading.Scene);
    }

    [Theory]
    [MemberData(nameof(SceneFolders.Scenes), "Broken/Syntax", MemberType = typeof(SceneFolders))]
    [MemberData(nameof(SceneFolders.Scenes), "Broken/Shape", MemberType = typeof(SceneFolders))]
    [MemberData(nameof(SceneFolders.Scenes), "Broken/Sense", MemberType = typeof(SceneFolders))]
    public void TheCaretStandsUnderTheCharacterAtLineAndColumn(string scene)
    {
        var file = SceneFolders.InTests(scene);
        var lines = Regex.Split(File.ReadAllText(file), "\r\n|\n|\r");
        foreach (var problem in SceneReader.Read(file).Problems)
        {
            var excerpt = problem.Excerpt.Split('\n');
            var shown = excerpt[0].PadRight(excerpt[1].Length);
            var character = (lines[problem.Line - 1] + " ")[problem.Column - 1];

            Assert.Equal(char.IsControl(character) && character != '\t' ? '\uFFFD' : character, shown[excerpt[1].IndexOf('^')]);
        }
    }

    /// <summary>What is expected; {types} in it stands for the types of the list, so that a new type changes none of these files.</summary>
    private static string Expected(string scene)
    {
        var file = Path.ChangeExtension(SceneFolders.InTests(scene), ".txt");
        return File.Exists(file) ? File.ReadAllText(file).ReplaceLineEndings("\n").Replace("{types}", Types) : "";
    }

    private static string Types =>
        string.Join(", ", PrimitiveList.Names.SkipLast(1).Select(name => $"\"{name}\"")) + $" or \"{PrimitiveList.Names[^1]}\"";

    /// <summary>The first line of each problem; without the scene's name, and FOLDER for its folder.</summary>
    private static string FirstLines(string scene, SceneReading reading)
    {
        var file = SceneFolders.InTests(scene);
        var folder = Path.GetDirectoryName(Path.GetFullPath(file))!;
        return string.Concat(reading.Problems.Select(problem =>
        {
            var line = problem.ToString().Split('\n')[0];
            Assert.StartsWith(file, line);
            var told = line[file.Length..].Replace(folder, "FOLDER");
            return Regex.Replace(told, "FOLDER[^:]*", path => path.Value.Replace(Path.DirectorySeparatorChar, '/')) + "\n";
        }));
    }
}
