namespace RayCaster.Testing;

/// <summary>The project's own files, found from wherever the tests run.</summary>
internal static class ProjectFolder
{
    /// <summary>The folder that the solution is in.</summary>
    public static string Root { get; } = FindRoot();

    /// <summary>The full path of a file or folder.</summary>
    /// <param name="path">The way from the root, with <c>/</c> between folders.</param>
    public static string PathOf(string path) => Path.GetFullPath(Path.Combine(Root, path));

    /// <summary>Whether a file is in scenes/my, which is for a user's own scenes.</summary>
    public static bool IsOwnScene(string file) =>
        file.StartsWith(PathOf("scenes/my") + Path.DirectorySeparatorChar, StringComparison.Ordinal);

    private static string FindRoot()
    {
        var folder = new DirectoryInfo(AppContext.BaseDirectory);
        while (!File.Exists(Path.Combine(folder.FullName, "RayCaster.sln")))
            folder = folder.Parent ?? throw new DirectoryNotFoundException("the tests run outside of the project's folder");
        return folder.FullName;
    }
}
