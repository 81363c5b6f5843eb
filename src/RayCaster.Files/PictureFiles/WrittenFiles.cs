namespace RayCaster.Files;

/// <summary>
/// What a process has written, and what it is writing. A program that must end at once, whatever its threads are doing, gives up what is not
/// finished and can
/// say what is.
/// </summary>
public static class WrittenFiles
{
    private static readonly Lock access = new();
    private static readonly HashSet<string> unfinished = []; // the temporary files
    private static bool isOver;

    /// <summary>How many files were put in their places.</summary>
    public static int Count { get; private set; }

    /// <summary>The last of them, as the caller named it; null if there is none.</summary>
    public static string? Last { get; private set; }

    /// <summary>Deletes what is not finished. From now on nothing is written, whichever thread tries.</summary>
    public static void GiveUp()
    {
        lock (access)
        {
            isOver = true;
            foreach (var temporary in unfinished.ToArray()) Delete(temporary);
        }
    }

    /// <summary>Makes a temporary file and keeps it in mind.</summary>
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

    /// <summary>Has a finished file put in its place.</summary>
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

    /// <summary>Deletes a file that is given up, which must not end in another error.</summary>
    internal static void Delete(string temporary)
    {
        lock (access) unfinished.Remove(temporary);
        try
        {
            File.Delete(temporary);
        }
        catch (Exception e) when (PictureFileException.IsCausedByFile(e))
        {
        }
    }
}
