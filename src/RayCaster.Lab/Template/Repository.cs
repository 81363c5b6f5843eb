namespace Lab;

/// <summary>The folder that holds src and scenes. You need not read this.</summary>
public static class Repository
{
    /// <summary>The full path of a file in it, wherever the program was started.</summary>
    public static string PathOf(string path)
    {
        var folder = new DirectoryInfo(AppContext.BaseDirectory);
        while (folder.Parent != null && !File.Exists(Path.Combine(folder.FullName, "scenes", "room.json"))) folder = folder.Parent;
        return Path.Combine(folder.FullName, path);
    }
}
