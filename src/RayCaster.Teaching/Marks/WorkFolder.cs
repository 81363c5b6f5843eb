namespace RayCaster.Teaching;

/// <summary>A new folder for one run of a student's program; deleted afterwards with all its content.</summary>
internal sealed class WorkFolder : IDisposable
{
    public string Path { get; } = Directory.CreateTempSubdirectory("raycaster-").FullName;

    /// <summary>Deletes the folder. Files that cannot be deleted stay in the system's folder for temporary files.</summary>
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

    /// <summary>Makes a folder for results, and the folders that contain it.</summary>
    /// <exception cref="ProblemException">It cannot be made.</exception>
    public static void Make(string path)
    {
        try
        {
            Directory.CreateDirectory(path);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException)
        {
            throw new ProblemException($"cannot make the folder {path}: {ProblemException.Reason(e)}", e);
        }
    }
}
