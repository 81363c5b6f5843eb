namespace RayCaster.Cli;

/// <summary>The clone of the repository that this program was built in.</summary>
internal static class Clone
{
    /// <summary>Its folder; null for an installed program.</summary>
    public static string? Folder()
    {
        var folder = new DirectoryInfo(AppContext.BaseDirectory);
        while (folder is not null && !File.Exists(Path.Combine(folder.FullName, "RayCaster.sln"))) folder = folder.Parent;
        return folder?.FullName;
    }
}
