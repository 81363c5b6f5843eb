namespace RayCaster.Files.Tests.Scenes;

/// <summary>Where the good and the broken scenes lie; beside each the problems to expect, one a line, in a file named .txt.</summary>
internal static class SceneFolders
{
    public static readonly string Root = ProjectFolder.Root;

    /// <summary>The scenes in a folder of the tests, as paths from that of the tests.</summary>
    public static TheoryData<string> Scenes(string folder) =>
        [.. Directory.GetFiles(InTests(folder), "*.json").Order(StringComparer.Ordinal).Select(file => $"{folder}/{Path.GetFileName(file)}")];

    public static string InTests(string path) => ProjectFolder.PathOf("tests/RayCaster.Files.Tests/" + path);
}
