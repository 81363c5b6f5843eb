namespace RayCaster.Files;

/// <summary>
/// Makes a folder completely or not at all. Files go to a temporary folder NAME.XXXXXXXX.dir beside it, which only <see cref="Commit"/>
/// renames. The locked file NAME.XXXXXXXX.tmp (<see cref="TemporaryFile"/>) shows that the folder is in use.
/// </summary>
public sealed class NewFolder : IDisposable
{
    private readonly string target;
    private readonly FileStream sign;

    /// <summary>Creates the temporary folder, and the folders above it.</summary>
    /// <param name="path">The folder; if it is there, it must be empty.</param>
    /// <exception cref="IOException">It cannot be created.</exception>
    /// <exception cref="UnauthorizedAccessException">It may not be created.</exception>
    public NewFolder(string path)
    {
        target = System.IO.Path.TrimEndingDirectorySeparator(System.IO.Path.GetFullPath(path));
        Directory.CreateDirectory(System.IO.Path.GetDirectoryName(target)!);
        sign = WrittenFiles.Begin(target);
        Path = TemporaryFile.FolderOf(sign.Name);
        Directory.CreateDirectory(Path);
    }

    /// <summary>The temporary folder.</summary>
    public string Path { get; }

    /// <summary>Gives the folder its name.</summary>
    /// <exception cref="IOException">A folder or file of this name came in between.</exception>
    public void Commit()
    {
        if (Directory.Exists(target)) Directory.Delete(target); // fails unless it is empty
        WrittenFiles.Finish(sign.Name, target, () => Directory.Move(Path, target));
    }

    /// <summary>Deletes the temporary folder unless it was committed.</summary>
    public void Dispose()
    {
        WrittenFiles.Delete(sign.Name);
        sign.Dispose();
    }
}
