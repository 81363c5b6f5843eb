namespace RayCaster.Tests.Mistakes;

/// <summary>The scene files of the project, found from wherever the tests run.</summary>
internal static class SceneFolder
{
    /// <summary>The folder that the solution is in.</summary>
    public static string Root { get; } = FindRoot();

    /// <summary>The scenes directly in a folder, sorted by name.</summary>
    /// <param name="folder">Relative to the root.</param>
    public static IEnumerable<string> Files(string folder) =>
        Directory.GetFiles(Path.Combine(Root, folder), "*.json")
            .Where(file => !file.EndsWith(".schema.json", StringComparison.Ordinal)).Order(StringComparer.Ordinal);

    /// <summary>What a scene is called: its path in the folder of scenes, without the extension.</summary>
    public static string NameOf(string file) =>
        Path.ChangeExtension(Path.GetRelativePath(Path.Combine(Root, "scenes"), file), null).Replace('\\', '/');

    /// <summary>The file of a scene.</summary>
    public static string FileOf(string name) => Path.Combine(Root, "scenes", name + ".json");

    /// <summary>The scene of a file that has no errors.</summary>
    public static Scene Read(string file)
    {
        var reading = SceneReader.Read(file);
        return reading.Scene ?? throw new InvalidDataException(reading.Report());
    }

    private static string FindRoot()
    {
        var folder = new DirectoryInfo(AppContext.BaseDirectory);
        while (!File.Exists(Path.Combine(folder.FullName, "RayCaster.sln")))
            folder = folder.Parent ?? throw new DirectoryNotFoundException("the tests run outside of the project's folder");
        return folder.FullName;
    }
}
