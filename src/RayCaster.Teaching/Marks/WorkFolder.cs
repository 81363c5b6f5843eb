namespace RayCaster.Teaching;

/// <summary>A fresh folder for a run of a student's program, which goes with all that is in it.</summary>
internal sealed class WorkFolder : IDisposable
{
    /// <summary>Where it is.</summary>
    public string Path { get; } = Directory.CreateTempSubdirectory("raycaster-").FullName;

    /// <summary>Deletes it; what cannot be deleted stays in the system's folder for temporary files.</summary>
    public void Dispose()
    {
        try
        {
            Directory.Delete(Path, recursive: true);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
        }
    }

    /// <summary>Makes a folder for results, and those above it.</summary>
    /// <exception cref="PictureFileException">It cannot be made.</exception>
    public static void Make(string path)
    {
        try
        {
            Directory.CreateDirectory(path);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException)
        {
            throw new PictureFileException($"cannot make the folder {path}: {PictureFileException.Reason(e)}", e);
        }
    }
}
