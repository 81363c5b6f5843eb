using System.Text;

namespace RayCaster.Files;

/// <summary>
/// The files NAME.XXXXXXXX.tmp, with eight hexadecimal digits, in which NAME is written before it is put in its place. The writer holds a lock on
/// its own from beginning to end, and the system takes the lock away when the writer is gone, however it went. So one that can be locked is an
/// orphan.
/// </summary>
internal static class TemporaryFile
{
    private const int MostAttempts = 5, LongestName = 255; // bytes
    private const string Ending = ".XXXXXXXX.tmp";

    /// <summary>Who may read, write and execute; not the bits that give a program its owner's rights.</summary>
    private const UnixFileMode Rights = (UnixFileMode)511;

    /// <summary>Unix renames a file that is locked for one; Windows only one that others may delete, which no orphan's finder does while it is
    /// written.</summary>
    private static FileShare Sharing => OperatingSystem.IsWindows() ? FileShare.Delete : FileShare.None;

    /// <summary>Begins to write beside a target.</summary>
    /// <exception cref="IOException">It cannot be made there.</exception>
    /// <exception cref="UnauthorizedAccessException">It may not be made there.</exception>
    public static FileStream Create(string target)
    {
        for (var attempt = 1; ; attempt++)
        {
            var path = $"{Beginning(target)}.{Random.Shared.Next():x8}.tmp";
            try
            {
                var file = new FileStream(path, Options(target));
                // Between its making and its locking another process may have found it and taken it for an orphan. From now on none can.
                if (File.Exists(path)) return file;
                file.Dispose();
            }
            catch (IOException) when (attempt < MostAttempts)
            {
                // Found by another process in between, and still in its hands, or there already by chance.
            }
        }
    }

    /// <summary>The old file's rights are the new one's from the beginning: what others may not read they cannot read meanwhile either.</summary>
    private static FileStreamOptions Options(string target)
    {
        var options = new FileStreamOptions { Mode = FileMode.CreateNew, Access = FileAccess.Write, Share = Sharing, BufferSize = 1 << 16 };
        if (!OperatingSystem.IsWindows() && File.Exists(target))
            options.UnixCreateMode = File.GetUnixFileMode(target) & Rights | UnixFileMode.UserWrite;
        return options;
    }

    /// <summary>The target's path, shortened where a name with the ending would be longer than file systems take.</summary>
    private static string Beginning(string target)
    {
        var name = Path.GetFileName(target);
        // the latter is refused whatever is done
        if (Encoding.UTF8.GetByteCount(name) is var bytes && (bytes <= LongestName - Ending.Length || bytes > LongestName)) return target;
        var length = name.Length;
        while (Encoding.UTF8.GetByteCount(name.AsSpan(0, length)) > LongestName - Ending.Length || char.IsHighSurrogate(name[length - 1])) length--;
        return target[..(target.Length - name.Length + length)];
    }

    /// <summary>Deletes what writers of the same target have left that had no time to tidy: killed, or cut off from power. Never fails.</summary>
    /// <param name="target">The full path of what is written.</param>
    /// <param name="own">The temporary file that is written now.</param>
    public static void DeleteOrphans(string target, string own)
    {
        try
        {
            var name = Path.GetFileName(Beginning(target));
            bool? locksHold = null;
            foreach (var path in Directory.EnumerateFiles(Path.GetDirectoryName(target)!))
                if (path != own && IsOneOf(name, Path.GetFileName(path)) && (locksHold ??= IsLocked(own)))
                    DeleteUnlessLocked(path);
        }
        catch (Exception e) when (PictureFileException.IsCausedByFile(e))
        {
            // A folder that may not be listed keeps its orphans.
        }
    }

    /// <summary>Whether a file is a temporary one of this target and no other's, though other names may begin with the target's.</summary>
    private static bool IsOneOf(string target, ReadOnlySpan<char> file)
    {
        if (file.Length != target.Length + Ending.Length || !file.StartsWith(target) || !file.EndsWith(".tmp")) return false;
        var digits = file[target.Length..^4];
        return digits[0] == '.' && !digits[1..].ContainsAnyExcept("0123456789abcdef");
    }

    /// <summary>Some network drives know no locks: there one's own file seems to be an orphan too, and all of them must stay.</summary>
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
            new FileStream(path, FileMode.Open, FileAccess.ReadWrite, FileShare.None, bufferSize: 0, FileOptions.DeleteOnClose).Dispose();
        }
        catch (Exception e) when (PictureFileException.IsCausedByFile(e))
        {
            // Somebody writes it, or it belongs to somebody else.
        }
    }
}
