namespace RayCaster.Files;

/// <summary>The temporary files in a folder at one moment. A program that writes many files lists their folder once: once for each file would be
/// quadratic in their number.</summary>
public sealed class TemporaryFileList
{
    /// <summary>Lists a folder. The list is empty if the folder cannot be listed.</summary>
    public TemporaryFileList(string folder)
    {
        try
        {
            Paths = Directory.GetFiles(Path.GetFullPath(folder), "*.tmp");
        }
        catch (Exception e) when (PictureFileException.IsCausedByFile(e))
        {
            // Writing the first file fails too, and says why.
        }
    }

    /// <summary>Full paths.</summary>
    internal string[] Paths { get; } = [];
}
