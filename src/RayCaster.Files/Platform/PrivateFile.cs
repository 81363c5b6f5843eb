namespace RayCaster.Files;

/// <summary>Small files that no other user of this machine may read.</summary>
internal static class PrivateFile
{
    /// <summary>The full path of a file in a folder that belongs to this user, which is made if it is missing.</summary>
    public static string PathOf(Environment.SpecialFolder folder, string file)
    {
        var path = Environment.GetFolderPath(folder, Environment.SpecialFolderOption.DoNotVerify);
        if (!Path.IsPathFullyQualified(path)) throw new IOException($"This user has no folder {folder}."); // no name, or below the current folder
        return Path.Combine(Directory.CreateDirectory(path).FullName, file);
    }

    public static void Write(string path, string text)
    {
        File.Delete(path); // an old file would keep its rights
        var options = new FileStreamOptions { Mode = FileMode.CreateNew, Access = FileAccess.Write };
        if (!OperatingSystem.IsWindows()) options.UnixCreateMode = UnixFileMode.UserRead | UnixFileMode.UserWrite;
        using var writer = new StreamWriter(path, options);
        writer.Write(text);
    }
}
