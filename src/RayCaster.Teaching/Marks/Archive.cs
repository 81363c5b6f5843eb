using System.IO.Compression;

namespace RayCaster.Teaching;

/// <summary>An archive of submissions as a learning platform gives it: a ZIP file of folders or of ZIP files, one for each student.</summary>
internal static class Archive
{
    private const int MaxEntries = 200_000;

    public static bool Is(string path) => File.Exists(path) && path.EndsWith(".zip", StringComparison.OrdinalIgnoreCase);

    /// <summary>Unpacks it into a folder beside it, with its name, and the archives of the students in it.</summary>
    /// <param name="maxBytes">How many bytes each archive may hold.</param>
    /// <param name="notice">Called with what is wrong with a student's archive, which then stays as it is.</param>
    /// <param name="cancellation">Ends the work; no folder is left.</param>
    /// <returns>The folder.</returns>
    /// <exception cref="ProblemException">The archive cannot be unpacked, or the folder exists.</exception>
    public static string Unpack(string path, Action<string>? notice, CancellationToken cancellation, long maxBytes = 1L << 32)
    {
        var folder = Path.ChangeExtension(Path.GetFullPath(path), null);
        if (Path.Exists(folder)) throw new ProblemException($"{folder} exists already: mark this folder, or delete it to unpack {path} again");
        WrittenFiles.WriteFolder(folder, made =>
        {
            Extract(path, made, maxBytes, name => name == Path.GetFileName(folder), cancellation);
            string[] all = [.. Directory.EnumerateFiles(made), .. Directory.EnumerateDirectories(made).SelectMany(Directory.EnumerateFiles)];
            foreach (var inner in all.Where(Is).Order(StringComparer.Ordinal))
                UnpackInner(inner, made, problem => notice?.Invoke(problem.Replace(made, folder)), cancellation, maxBytes);
        });
        return folder;
    }

    private static void UnpackInner(string inner, string folder, Action<string> notice, CancellationToken cancellation, long maxBytes)
    {
        var student = Path.GetDirectoryName(inner)!;
        var isAlone = student != folder && Directory.GetFileSystemEntries(student).Length == 1; // what it contains is moved up
        var unpacked = isAlone ? Path.Combine(folder, ".unpacked") : Path.ChangeExtension(inner, null);
        try
        {
            if (Path.Exists(unpacked)) throw new ProblemException($"cannot unpack {inner}: {unpacked} exists already");
            Extract(inner, unpacked, maxBytes, _ => true, cancellation);
            File.Delete(inner);
            if (!isAlone) return;
            Directory.Delete(student);
            Directory.Move(unpacked, student);
        }
        catch (ProblemException e)
        {
            notice(e.Message);
            if (student == folder && !Path.Exists(unpacked)) Directory.CreateDirectory(unpacked); // a row for the student
        }
    }

    /// <summary>Unpacks all, or nothing: no entry may lead elsewhere, and no link is made.</summary>
    /// <param name="mayMoveUp">Whether a folder of this name that holds everything is left out: hosting sites put one around a
    /// repository.</param>
    private static void Extract(string path, string folder, long left, Predicate<string> mayMoveUp, CancellationToken cancellation)
    {
        try
        {
            using var archive = ZipFile.OpenRead(path);
            if (archive.Entries.Count > MaxEntries) throw new ProblemException($"{path} has more than {MaxEntries} files");
            Directory.CreateDirectory(folder);
            foreach (var entry in archive.Entries) Extract(entry, path, folder, ref left, cancellation);
            if (Directory.GetFileSystemEntries(folder) is [var only] && Directory.Exists(only) && mayMoveUp(Path.GetFileName(only))) MoveUp(only);
        }
        catch (Exception e) when (e is IOException or InvalidDataException or UnauthorizedAccessException or ArgumentException or ProblemException)
        {
            if (Directory.Exists(folder)) Directory.Delete(folder, recursive: true);
            throw e as ProblemException ?? new ProblemException($"cannot unpack {path}: {ProblemException.Reason(e)}", e);
        }
    }

    private static void MoveUp(string only)
    {
        var folder = Path.GetDirectoryName(only)!;
        var moved = Path.Combine(folder, ".moved"); // it may hold a folder of its own name
        Directory.Move(only, moved);
        foreach (var entry in Directory.GetFileSystemEntries(moved)) Directory.Move(entry, Path.Combine(folder, Path.GetFileName(entry)));
        Directory.Delete(moved);
    }

    private static void Extract(ZipArchiveEntry entry, string path, string folder, ref long left, CancellationToken cancellation)
    {
        const int typeOfFile = 0xF000, link = 0xA000;
        var mode = entry.ExternalAttributes >> 16;
        var name = entry.FullName.Replace('\\', '/');
        if (name.StartsWith("__MACOSX/", StringComparison.Ordinal)) return; // what macOS knows about the files
        var target = Path.GetFullPath(Path.Combine(folder, name));
        if (!target.StartsWith(folder + Path.DirectorySeparatorChar, StringComparison.Ordinal) || (mode & typeOfFile) == link || entry.IsEncrypted)
            throw new ProblemException(
                $"cannot unpack {path}: its entry {PrintableText.Of(entry.FullName)} leads out of it, is a link or is encrypted");
        Directory.CreateDirectory(name.EndsWith('/') ? target : Path.GetDirectoryName(target)!);
        if (name.EndsWith('/')) return;
        using var from = entry.Open();
        using var to = File.Create(target);
        var buffer = new byte[81920];
        for (int read; (read = from.Read(buffer)) > 0; to.Write(buffer.AsSpan(0, read)))
        {
            cancellation.ThrowIfCancellationRequested();
            if ((left -= read) < 0) throw new ProblemException($"cannot unpack {path}: it holds too many bytes");
        }
        if (!OperatingSystem.IsWindows() && (mode & 0x49) != 0) File.SetUnixFileMode(target, (UnixFileMode)0x1ED); // a program
    }
}
