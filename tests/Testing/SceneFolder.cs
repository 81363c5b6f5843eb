namespace RayCaster.Testing;

/// <summary>The scene files of the project.</summary>
internal static class SceneFolder
{
    /// <summary>The scenes directly in a folder, sorted by name.</summary>
    /// <param name="folder">Relative to the root.</param>
    public static IEnumerable<string> Files(string folder) =>
        Directory.GetFiles(ProjectFolder.PathOf(folder), "*.json")
            .Where(file => !file.EndsWith(".schema.json", StringComparison.Ordinal)).Order(StringComparer.Ordinal);

    /// <summary>All scenes of the project by name, those in folders too, but not a user's own.</summary>
    public static IEnumerable<string> Names =>
        Directory.GetFiles(ProjectFolder.PathOf("scenes"), "*.json", SearchOption.AllDirectories)
            .Where(file => !file.EndsWith(".schema.json", StringComparison.Ordinal) && !ProjectFolder.IsOwnScene(file))
            .Select(NameOf).Order(StringComparer.Ordinal);

    /// <summary>What a scene is called: its path in the folder of scenes, without the extension.</summary>
    public static string NameOf(string file) =>
        Path.ChangeExtension(Path.GetRelativePath(ProjectFolder.PathOf("scenes"), file), null).Replace('\\', '/');

    /// <summary>The file of a scene.</summary>
    public static string FileOf(string name) => ProjectFolder.PathOf($"scenes/{name}.json");

    /// <summary>The scene of a file that has no errors.</summary>
    public static Scene Read(string file)
    {
        var reading = SceneReader.Read(file);
        return reading.Scene ?? throw new InvalidDataException(reading.Report());
    }

    /// <summary>A scene with a smaller picture, which takes less time.</summary>
    /// <param name="name">As <see cref="NameOf"/> gives it.</param>
    /// <param name="divisor">Of width and height.</param>
    public static Scene Small(string name, int divisor = 2)
    {
        var scene = Read(FileOf(name));
        return scene.WithSize(scene.Camera.Width / divisor, scene.Camera.Height / divisor);
    }
}
