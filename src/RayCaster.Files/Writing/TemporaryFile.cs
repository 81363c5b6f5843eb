using System.Collections.Concurrent;
using System.Text.RegularExpressions;

namespace RayCaster.Files;

/// <summary>
/// The files NAME.XXXXXXXX.tmp, with eight random hexadecimal digits, in which NAME is written before it is put in its place. A writer locks its
/// temporary file until the end, and the system removes the lock when the writer's process ends in any way. So a temporary file that can be
/// locked is an orphan, and is deleted when NAME is written again.
/// </summary>
internal static class TemporaryFile
{
    private const int MostAttempts = 5, LongestName = 255; // bytes
    private const string Ending = ".XXXXXXXX.tmp";

    /// <summary>The temporary files that each folder had when this process first wrote a file in it. To list a folder once for each of many files
    /// would be quadratic in their number.</summary>
    private static readonly ConcurrentDictionary<string, string[]> foundIn = new();

    /// <summary>The rights to read, write and execute, without set-user-ID and the like.</summary>
    private const UnixFileMode Rights = (UnixFileMode)511;

    /// <summary>Unix can rename a file that is not shared. Windows needs FileShare.Delete; other writers still cannot open the file.</summary>
    private static FileShare Sharing => OperatingSystem.IsWindows() ? FileShare.Delete : FileShare.None;

    /// <summary>The folder that belongs to a temporary file where a whole folder is written; it is deleted with the file.</summary>
    public static string FolderOf(string temporary) => Path.ChangeExtension(temporary, ".dir");

    /// <summary>Deletes that folder; of a link only the link.</summary>
    public static void DeleteFolderOf(string temporary)
    {
        if (FolderOf(temporary) is var folder && Directory.Exists(folder)) Directory.Delete(folder, recursive: true);
    }

    /// <summary>Creates a temporary file beside its target.</summary>
    public static FileStream Create(string target)
    {
        for (var attempt = 1; ; attempt++)
        {
            var path = $"{Beginning(target)}.{Random.Shared.Next():x8}.tmp";
            try
            {
                var file = new FileStream(path, Options(target));
                // Before the lock another process may have found the file and deleted it as an orphan. From now on none can.
                if (File.Exists(path)) return file;
                file.Dispose();
            }
            catch (IOException) when (attempt < MostAttempts)
            {
                // Another process has found the file before the lock and still holds it, or a file has the same name by chance.
            }
        }
    }

    /// <summary>The new file has the old one's rights from the beginning, so that only users who could read the old one can read it.</summary>
    private static FileStreamOptions Options(string target)
    {
        var options = new FileStreamOptions { Mode = FileMode.CreateNew, Access = FileAccess.Write, Share = Sharing, BufferSize = 1 << 16 };
        if (!OperatingSystem.IsWindows() && File.Exists(target))
            options.UnixCreateMode = File.GetUnixFileMode(target) & Rights | UnixFileMode.UserWrite;
        return options;
    }

    /// <summary>The target's path, shortened if the name with the ending would be too long for file systems.</summary>
    private static string Beginning(string target)
    {
        var name = Path.GetFileName(target);
        // A name that is too long by itself is refused in any case.
        if (Encoding.UTF8.GetByteCount(name) is var bytes && (bytes <= LongestName - Ending.Length || bytes > LongestName)) return target;
        var length = name.Length;
        while (Encoding.UTF8.GetByteCount(name.AsSpan(0, length)) > LongestName - Ending.Length || char.IsHighSurrogate(name[length - 1])) length--;
        return target[..(target.Length - name.Length + length)];
    }

    /// <summary>Deletes the temporary files of writers of the same target that were killed. Never fails.</summary>
    public static void DeleteOrphans(string target, string own)
    {
        try
        {
            var name = Path.GetFileName(Beginning(target));
            bool? locksHold = null;
            foreach (var path in foundIn.GetOrAdd(Path.GetDirectoryName(target)!, folder => Directory.GetFiles(folder, "*.tmp")))
                if (path != own && IsOneOf(name, Path.GetFileName(path)) && (locksHold ??= IsLocked(own)))
                    DeleteUnlessLocked(path);
        }
        catch (Exception e) when (PictureFileException.IsCausedByFile(e))
        {
            // In a folder that cannot be listed, orphans stay.
        }
    }

    /// <summary>Whether a file is a temporary file of this target. Other targets' names may begin with this one's.</summary>
    private static bool IsOneOf(string target, string file) => Regex.IsMatch(file, $@"^{Regex.Escape(target)}\.[0-9a-f]{{8}}\.tmp\z");

    /// <summary>Whether the own file is locked. On some network drives it is not; then every file looks like an orphan, and none may be
    /// deleted.</summary>
    private static bool IsLocked(string own)
    {
        try
        {
            using var second = new FileStream(own, FileMode.Open, FileAccess.ReadWrite, FileShare.None);
            return false;
        }
        catch (IOException)
        {
            return true;
        }
    }

    private static void DeleteUnlessLocked(string path)
    {
        try
        {
            using var file = new FileStream(path, FileMode.Open, FileAccess.ReadWrite, FileShare.None, bufferSize: 0, FileOptions.DeleteOnClose);
            DeleteFolderOf(path);
        }
        catch (Exception e) when (PictureFileException.IsCausedByFile(e))
        {
            // Another process writes it, or it belongs to another user.
        }
    }
}
