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

    /// <summary>Creates a temporary file and remembers it as unfinished.</summary>
    /// <exception cref="OperationCanceledException">The process ends.</exception>
    internal static FileStream Begin(Func<FileStream> create)
    {
        lock (access)
        {
            if (isOver) throw new OperationCanceledException();
            var file = create();
            unfinished.Add(file.Name);
            return file;
        }
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
