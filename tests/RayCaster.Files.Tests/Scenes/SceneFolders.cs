namespace RayCaster.Files.Tests.Scenes;

/// <summary>Where the good and the broken scenes lie; beside each the problems to expect, one a line, in a file named .txt.</summary>
internal static class SceneFolders
{
    public static readonly string Root = ProjectFolder.Root;

    /// <summary>The scenes in a folder of the tests, as paths from that of the tests.</summary>
    public static TheoryData<string> Scenes(params string[] folders)
    {
        var scenes = new TheoryData<string>();
        foreach (var folder in folders)
            foreach (var file in Directory.GetFiles(InTests(folder), "*.json").Order(StringComparer.Ordinal))
                scenes.Add($"{folder}/{Path.GetFileName(file)}");
        return scenes;
    }

    public static string InTests(string path) => ProjectFolder.PathOf("tests/RayCaster.Files.Tests/" + path);
}
