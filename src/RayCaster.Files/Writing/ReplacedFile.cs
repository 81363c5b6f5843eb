namespace RayCaster.Files;

/// <summary>
/// Writes a file completely or not at all. The bytes go to a temporary file beside it (<see cref="TemporaryFile"/>), and only
/// <see cref="Commit"/> puts that in the place of the old file. A symbolic link is replaced, not followed.
/// </summary>
internal sealed class ReplacedFile : ForwardStream
{
    private readonly string path, target;
    private readonly FileStream file;
    private bool closed;

    /// <summary>Creates the temporary file; the old file stays as it is.</summary>
    /// <exception cref="PictureFileException">
    /// The path is a folder or a device, its folder is /dev, does not exist or may not be written to, or the old file is read-only.
    /// </exception>
    public ReplacedFile(string path)
    {
        this.path = path;
        try
        {
            if (path.Length == 0 || path.Contains('\0')) throw new PictureFileException($"'{path.Replace("\0", @"\x00")}' is no file name");
            target = Path.GetFullPath(path);
            var folder = Path.GetDirectoryName(target);
            if (Directory.Exists(target) || folder is null || Path.EndsInDirectorySeparator(target))
                throw Failure("it is a folder; name a file in it");
            if (folder == "/dev") throw Failure("its folder is for devices, not for files"); // root would lose /dev/null
            if (!Directory.Exists(folder)) throw Failure("its folder does not exist", $"\n  make the folder {PrintableText.Of(folder)} first");
            if (!FileKind.MayBeReplaced(target))
                throw Failure("it is a device, a pipe or a socket, or a link to something else than a file; name a file");
            if (File.Exists(target) && File.GetAttributes(target).HasFlag(FileAttributes.ReadOnly))
                throw Failure("the old file is read-only");
            file = WrittenFiles.Begin(target);
        }
        catch (Exception e) when (e is UnauthorizedAccessException or FileNotFoundException) // the latter in a folder like /proc
        {
            throw Failure("you may not write to its folder", cause: e);
        }
        catch (IOException e)
        {
            throw Failure(e);
        }
    }

    public override bool CanWrite => !closed;

    /// <summary>Writes the file to the disk and puts it in the place of the old one, which is there until then.</summary>
    /// <exception cref="PictureFileException">The disk is full, or the file cannot be put there. The old one stays.</exception>
    public void Commit(Action? beforeReplacing = null)
    {
        try
        {
            // A network drive reports only now that the quota is used up, and then the old picture must still be there.
            file.Flush(flushToDisk: true);
            beforeReplacing?.Invoke();
            // It is moved while it is locked: another writer would delete an unlocked one as an orphan.
            WrittenFiles.Finish(file.Name, path, () => File.Move(file.Name, target, overwrite: true));
            closed = true;
            file.Dispose();
        }
        catch (Exception e) when (PictureFileException.IsCausedByFile(e))
        {
            throw Failure(e);
        }
    }

    /// <exception cref="PictureFileException">The disk is full or gone.</exception>
    public override void Write(ReadOnlySpan<byte> buffer)
    {
        try
        {
            file.Write(buffer);
        }
        catch (Exception e) when (PictureFileException.IsCausedByFile(e))
        {
            throw Failure(e);
        }
    }

    /// <summary>Deletes the temporary file unless it was committed; the old file stays.</summary>
    protected override void Dispose(bool disposing)
    {
        if (closed || !disposing) return;
        closed = true;
        try
        {
            file.Dispose();
        }
        catch (Exception e) when (PictureFileException.IsCausedByFile(e))
        {
            // Buffered bytes may not fit on the disk. This must not hide the error that gave the file up.
        }
        WrittenFiles.Delete(file.Name);
        base.Dispose(disposing);
    }

    private PictureFileException Failure(Exception cause) => Failure(PictureFileException.Reason(cause), cause: cause);

    private PictureFileException Failure(string reason, string hint = "", Exception? cause = null) =>
        new($"cannot write {path}: {reason}{hint}", cause) { NamesFile = true };
}
