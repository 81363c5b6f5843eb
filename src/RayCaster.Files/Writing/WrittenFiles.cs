namespace RayCaster.Files;

/// <summary>
/// The files that this process has written and is writing. A program that must end at once deletes the unfinished ones, whatever its threads
/// are doing, and can name the finished ones.
/// </summary>
public static class WrittenFiles
{
    private static readonly Lock access = new();
    private static readonly HashSet<string> unfinished = []; // the temporary files
    private static bool isOver;

    /// <summary>How many files are finished.</summary>
    public static int Count { get; private set; }

    /// <summary>The last finished file, as the caller named it; null if there is none.</summary>
    public static string? Last { get; private set; }

    /// <summary>Deletes unfinished files. From now on no thread can begin or finish one.</summary>
    public static void GiveUp()
    {
        lock (access)
        {
            isOver = true;
            foreach (var temporary in unfinished.ToArray()) Delete(temporary);
        }
    }

    /// <summary>Writes a file completely or not at all: an old one is replaced at the end, and stays if anything fails.</summary>
    /// <param name="beforeReplacing">Called when all bytes are on the disk; if it throws, the old file stays.</param>
    /// <exception cref="PictureFileException">The file cannot be written.</exception>
    public static void Write(string path, Action<Stream> write, CancellationToken cancellation = default, Action? beforeReplacing = null)
    {
        using var file = new ReplacedFile(path);
        write(file);
        cancellation.ThrowIfCancellationRequested();
        file.Commit(beforeReplacing);
    }

    /// <summary>
    /// Makes a folder completely or not at all. Files go to a temporary folder NAME.XXXXXXXX.dir beside it, which is renamed at the end. The locked
    /// file NAME.XXXXXXXX.tmp (<see cref="TemporaryFile"/>) shows that the folder is in use.
    /// </summary>
    /// <param name="path">The folder; if it is there, it must be empty. The folders above it are made, too.</param>
    /// <param name="fill">Fills the temporary folder, whose path it gets.</param>
    /// <exception cref="PictureFileException">It cannot be written, or a folder or file of this name came in between.</exception>
    public static void WriteFolder(string path, Action<string> fill)
    {
        try
        {
            WriteAndMove(Path.TrimEndingDirectorySeparator(Path.GetFullPath(path)), fill);
        }
        catch (Exception e) when (PictureFileException.IsCausedByFile(e))
        {
            throw new PictureFileException($"cannot write the folder {PrintableText.Of(path)}: {PictureFileException.Reason(e)}", e);
        }
    }

    private static void WriteAndMove(string target, Action<string> fill)
    {
        Directory.CreateDirectory(Path.GetDirectoryName(target)!);
        using var sign = Begin(target);
        try
        {
            var folder = TemporaryFile.FolderOf(sign.Name);
            Directory.CreateDirectory(folder);
            fill(folder);
            if (Directory.Exists(target)) Directory.Delete(target); // fails unless it is empty
            Finish(sign.Name, target, () => Directory.Move(folder, target));
        }
        finally
        {
            Delete(sign.Name);
        }
    }

    /// <summary>Creates a temporary file for a target, remembers it as unfinished, and deletes what killed runs have left of the target.</summary>
    /// <exception cref="OperationCanceledException">The process ends.</exception>
    /// <exception cref="IOException">It cannot be created.</exception>
    /// <exception cref="UnauthorizedAccessException">It may not be created.</exception>
    internal static FileStream Begin(string target)
    {
        FileStream file;
        lock (access)
        {
            if (isOver) throw new OperationCanceledException();
            file = TemporaryFile.Create(target);
            unfinished.Add(file.Name);
        }
        TemporaryFile.DeleteOrphans(target, file.Name);
        return file;
    }

    /// <summary>Puts a finished file in its place.</summary>
    /// <exception cref="OperationCanceledException">The process ends.</exception>
    internal static void Finish(string temporary, string path, Action move)
    {
        lock (access)
        {
            if (isOver) throw new OperationCanceledException();
            move();
            unfinished.Remove(temporary);
            (Count, Last) = (Count + 1, path);
        }
    }

    /// <summary>Deletes an unfinished file, and before it the unfinished folder that belongs to it. Never fails.</summary>
    internal static void Delete(string temporary)
    {
        lock (access) // of two threads that deleted the same folder, both would fail
        {
            unfinished.Remove(temporary);
            try
            {
                TemporaryFile.DeleteFolderOf(temporary);
                File.Delete(temporary);
            }
            catch (Exception e) when (PictureFileException.IsCausedByFile(e))
            {
                // The next run that writes the same deletes what is left.
            }
        }
    }
}
