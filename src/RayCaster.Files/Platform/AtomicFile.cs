using Microsoft.Win32.SafeHandles;

namespace RayCaster.Files;

/// <summary>
/// Writes files completely or not at all: to a temporary file NAME.XXXXXXXX.tmp beside the target, with eight random hexadecimal digits, which
/// takes the target's place at the end. A program that must end at once deletes the temporary files, whatever its threads are doing, and can
/// name the finished ones.
/// </summary>
internal sealed class AtomicFile : IDisposable
{
    private const string Circle = "symbolic links lead in a circle";

    private static readonly Lock access = new();
    private static readonly HashSet<string> unfinished = []; // the temporary files and folders
    private static bool isAborted;

    private readonly string path, target, temporary;
    private readonly bool isFile;
    private readonly FileStream file;

    public static int Count { get; private set; }

    /// <summary>The last finished file, as the caller named it; null if there is none.</summary>
    public static string? Last { get; private set; }

    /// <summary>Deletes unfinished files. From now on no thread can begin or finish one.</summary>
    public static void Abort()
    {
        lock (access)
        {
            isAborted = true;
            foreach (var temporary in unfinished.ToArray()) Delete(temporary);
        }
    }

    /// <summary>Begins a file. An old one stays until the new one is complete. A symbolic link is followed. What is no file, such as a device or a
    /// pipe, is not replaced: it gets the bytes when they are complete.</summary>
    public AtomicFile(string path)
    {
        this.path = path;
        try
        {
            target = TargetOf(path);
            isFile = PathResolver.IsFileOrFree(target);
            temporary = NameBeside(isFile ? target : Path.Join(Path.GetTempPath(), Path.GetFileName(target)));
            file = Create(path, isFile ? target : null, temporary);
        }
        catch (Exception e) when (ProblemException.IsCausedByFile(e))
        {
            throw Failure(e);
        }
    }

    /// <summary>Takes the file's bytes. Its exceptions are the system's: <see cref="Failure(Exception)"/> says them in words.</summary>
    public Stream Stream => file;

    /// <param name="beforeReplacing">Called when all bytes are on the disk; if it throws, the old file stays.</param>
    public void Finish(Action? beforeReplacing = null) => Do(() =>
    {
        // A network drive reports only now that the quota is used up, and then the old picture must still be there.
        file.Flush(flushToDisk: isFile);
        beforeReplacing?.Invoke();
        if (!isFile) Copy(file, target);
        Finish(temporary, path, isFile ? () => Replace(path, target, temporary) : () => File.Delete(temporary));
    });

    public ProblemException Failure(Exception e) => Failure(path, ProblemException.Reason(e), e);

    public void Dispose()
    {
        try
        {
            file.Dispose();
        }
        catch (Exception e) when (ProblemException.IsCausedByFile(e))
        {
            // Of a file that is not wanted. This must not hide the error before.
        }
        Delete(temporary);
    }

    public static void Write(string path, Action<Stream> write, Action? beforeReplacing = null)
    {
        using var file = new AtomicFile(path);
        file.Do(() => write(file.Stream));
        file.Finish(beforeReplacing);
    }

    private void Do(Action work)
    {
        try
        {
            work();
        }
        catch (Exception e) when (ProblemException.IsCausedByFile(e))
        {
            throw Failure(e);
        }
    }

    /// <summary>Makes a folder: files go to a temporary folder beside it, which is renamed at the end.</summary>
    /// <param name="path">The folder; the folders above it are made, too. If it is there, it must be empty, and stays: a shell may be in it, a link
    /// may lead to it, it may be a disk. Then the temporary folder is in it, and at the end what that holds is moved.</param>
    /// <param name="fill">Fills the temporary folder, whose path it gets, by <see cref="WriteInFolder"/>.</param>
    public static void WriteFolder(string path, Action<string> fill)
    {
        string? temporary = null;
        try
        {
            var target = PathResolver.Resolve(path) ?? throw new IOException(Circle);
            var isThere = Directory.Exists(target);
            temporary = NameBeside(isThere ? Path.Join(target, Path.GetFileName(target)) : target);
            Begin(temporary, () => Directory.CreateDirectory(temporary));
            fill(temporary);
            Finish(temporary, target, isThere ? () => MoveUp(temporary, target) : () => Directory.Move(temporary, target));
        }
        catch (Exception e) when (ProblemException.IsCausedByFile(e))
        {
            throw new ProblemException($"cannot write the folder {PrintableText.From(path)}: {ProblemException.Reason(e)}", e);
        }
        finally
        {
            if (temporary is not null) Delete(temporary);
        }
    }

    /// <summary>Writes a file of a folder that is being made, and the folders above it. After <see cref="Abort"/> there is none.</summary>
    public static void WriteInFolder(string path, byte[] content)
    {
        lock (access)
        {
            if (isAborted) throw new OperationCanceledException();
            Directory.CreateDirectory(Path.GetDirectoryName(path)!);
            File.WriteAllBytes(path, content);
        }
    }

    private static void MoveUp(string temporary, string target)
    {
        if (Directory.EnumerateFileSystemEntries(target).Skip(1).Any()) throw new IOException("It is not empty.");
        foreach (var entry in Directory.GetFileSystemEntries(temporary)) Directory.Move(entry, Path.Join(target, Path.GetFileName(entry)));
        Directory.Delete(temporary);
    }

    private static string TargetOf(string path)
    {
        MissingFileHint.ThrowIfImpossible(path);
        if (OperatingSystem.IsWindows() && PathResolver.IsDeviceOnWindows(Path.GetFileName(path)))
            throw Failure(path, $"{Path.GetFileName(path)} is the name of a device on Windows; choose another");
        var target = PathResolver.Resolve(path) ?? throw Failure(path, Circle);
        // Windows says of such a name only that its syntax is wrong.
        if (OperatingSystem.IsWindows() && Path.GetFileName(target).Length > 255) throw Failure(path, "the name is too long");
        var folder = Path.GetDirectoryName(target);
        if (Directory.Exists(target) || folder is null || Path.EndsInDirectorySeparator(path))
            throw Failure(path, "it is a folder; name a file in it");
        if (PathResolver.DescriptorOf(target) is not null && !File.Exists(target)) throw Failure(path, "nothing is open by this number");
        if (folder == "/dev" && !File.Exists(target)) throw Failure(path, "its folder is for devices, not for files");
        if (!Directory.Exists(folder))
            throw Failure(path, $"its folder does not exist\n  make the folder {PrintableText.From(folder)} first");
        if (File.Exists(target) && File.GetAttributes(target).HasFlag(FileAttributes.ReadOnly)) throw Failure(path, "the old file is read-only");
        return target;
    }

    /// <summary>The name for a temporary file. A long name is shortened, because file systems take up to 255 bytes.</summary>
    private static string NameBeside(string target)
    {
        var name = Path.GetFileName(target);
        return Path.Combine(Path.GetDirectoryName(target)!, $"{name[..Math.Min(name.Length, 60)]}.{Random.Shared.Next():x8}.tmp");
    }

    /// <summary>Creates a temporary file with the old file's rights, so that only users who could read the old one can read it.</summary>
    /// <param name="target">The file that it will replace; null if only this user may read it.</param>
    private static FileStream Create(string path, string? target, string temporary)
    {
        var options = new FileStreamOptions
        {
            Mode = FileMode.CreateNew,
            Access = target is null ? FileAccess.ReadWrite : FileAccess.Write,
            Share = FileShare.Delete,
            BufferSize = 1 << 16,
        };
        if (!OperatingSystem.IsWindows() && (target is null || File.Exists(target)))
            options.UnixCreateMode = UnixFileMode.UserWrite
                | (target is null ? UnixFileMode.UserRead : File.GetUnixFileMode(target) & (UnixFileMode)0b111_111_111);
        try
        {
            return Begin(temporary, () => new FileStream(temporary, options));
        }
        catch (Exception e) when (e is UnauthorizedAccessException or FileNotFoundException) // the latter in a folder like /proc
        {
            throw Failure(path, "you may not write to its folder", e);
        }
    }

    private static T Begin<T>(string temporary, Func<T> create)
    {
        lock (access)
        {
            if (isAborted) throw new OperationCanceledException();
            var created = create();
            unfinished.Add(temporary);
            return created;
        }
    }

    private static void Finish(string temporary, string path, Action move)
    {
        lock (access)
        {
            if (isAborted) throw new OperationCanceledException();
            move();
            unfinished.Remove(temporary);
            Count++;
            Last = path;
        }
    }

    /// <summary>Copies a complete file to what is no file. This may wait, for the reader of a pipe.</summary>
    private static void Copy(FileStream file, string target)
    {
        file.Position = 0;
        using var output = PathResolver.DescriptorOf(target) is { } number
            ? new FileStream(new SafeFileHandle(number, ownsHandle: false), FileAccess.Write, bufferSize: 0)
            : new FileStream(target, FileMode.Open, FileAccess.Write, FileShare.ReadWrite | FileShare.Delete, bufferSize: 0);
        file.CopyTo(output);
        _ = output.SafeFileHandle; // moves the descriptor's own place to the end: other programs go on there
    }

    private static void Replace(string path, string target, string temporary)
    {
        for (var attempt = 1; ; attempt++)
        {
            try
            {
                File.Move(temporary, target, overwrite: true);
                return;
            }
            catch (UnauthorizedAccessException e) when (OperatingSystem.IsWindows()) // the folder is writable: the temporary file is in it
            {
                if (attempt == 10) throw Failure(path, ProblemException.OpenElsewhere, e);
                Thread.Sleep(50); // a virus scanner or another writer has the target open for a moment
            }
        }
    }

    /// <summary>Deletes a temporary file or folder unless it is finished. Never fails.</summary>
    private static void Delete(string temporary)
    {
        lock (access) // of two threads that deleted the same folder, both would fail
        {
            if (!unfinished.Remove(temporary)) return;
            try
            {
                if (Directory.Exists(temporary)) Directory.Delete(temporary, recursive: true);
                else File.Delete(temporary);
            }
            catch (Exception e) when (ProblemException.IsCausedByFile(e))
            {
                // It stays. This must not hide the error before.
            }
        }
    }

    private static ProblemException Failure(string path, string reason, Exception? cause = null) =>
        new($"cannot write {path}: {reason}", cause) { NamesFile = true };
}
