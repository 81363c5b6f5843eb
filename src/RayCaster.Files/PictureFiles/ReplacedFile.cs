namespace RayCaster.Files;

/// <summary>
/// A file that is there whole or not at all: what is written goes to a temporary file beside it, and only <see cref="Commit"/> puts that in
/// the place of the old one. The temporary file is named NAME.XXXXXXXX.tmp with eight random hexadecimal digits and is locked while it
/// is written; what is not locked was left by a writer that was killed, and goes when NAME is written again. A symbolic link is replaced, not
/// followed.
/// </summary>
public sealed class ReplacedFile : Stream
{
    private readonly string path, target, temporary;
    private readonly FileStream file;
    private bool closed;

    /// <summary>Begins to write; the old file stays as it is.</summary>
    /// <exception cref="PictureFileException">
    /// The path is a folder or a device, its folder is that of the devices, does not exist or may not be written to, or the old file is read-only.
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
            file = WrittenFiles.Begin(() => TemporaryFile.Create(target));
            temporary = file.Name;
            TemporaryFile.DeleteOrphans(target, temporary);
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

    /// <summary>True until the file is committed or given up.</summary>
    public override bool CanWrite => !closed;

    /// <summary>Always false: nothing is read back.</summary>
    public override bool CanRead => false;

    /// <summary>Always false: bytes are written in order.</summary>
    public override bool CanSeek => false;

    /// <summary>Not supported.</summary>
    public override long Length => throw new NotSupportedException();

    /// <summary>Not supported.</summary>
    public override long Position
    {
        get => throw new NotSupportedException();
        set => throw new NotSupportedException();
    }

    /// <summary>Brings the file to the disk and puts it in the place of the old one, which is there until then.</summary>
    /// <exception cref="PictureFileException">The disk is full, or the file cannot be put there. The old one stays.</exception>
    public void Commit()
    {
        ObjectDisposedException.ThrowIf(closed, this);
        try
        {
            // To the disk: a network drive tells only now that the quota is used up, and by then the old picture must still be there.
            file.Flush(flushToDisk: true);
            // While it is locked, lest somebody take it for an orphan.
            WrittenFiles.Finish(temporary, path, () => File.Move(temporary, target, overwrite: true));
            closed = true;
            file.Dispose();
        }
        catch (Exception e) when (PictureFileException.IsCausedByFile(e))
        {
            throw Failure(e);
        }
    }

    /// <summary>Writes bytes.</summary>
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

    /// <inheritdoc cref="Write(ReadOnlySpan{byte})"/>
    public override void Write(byte[] buffer, int offset, int count) => Write(buffer.AsSpan(offset, count));

    /// <summary>Hands what is buffered to the system.</summary>
    /// <exception cref="PictureFileException">The disk is full or gone.</exception>
    public override void Flush()
    {
        try
        {
            file.Flush();
        }
        catch (Exception e) when (PictureFileException.IsCausedByFile(e))
        {
            throw Failure(e);
        }
    }

    /// <summary>Not supported.</summary>
    public override int Read(byte[] buffer, int offset, int count) => throw new NotSupportedException();

    /// <summary>Not supported.</summary>
    public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();

    /// <summary>Not supported.</summary>
    public override void SetLength(long value) => throw new NotSupportedException();

    /// <summary>Gives the file up unless it was committed: the temporary file goes, the old one stays.</summary>
    protected override void Dispose(bool disposing)
    {
        if (closed || !disposing) return;
        closed = true;
        Quietly(file.Dispose); // what is still buffered may not fit on the disk
        WrittenFiles.Delete(temporary);
        base.Dispose(disposing);
    }

    /// <summary>Tidies up after an error, which must not hide behind another.</summary>
    private static void Quietly(Action tidy)
    {
        try
        {
            tidy();
        }
        catch (Exception e) when (PictureFileException.IsCausedByFile(e))
        {
        }
    }

    private PictureFileException Failure(Exception cause) => Failure(PictureFileException.Reason(cause), cause: cause);

    private PictureFileException Failure(string reason, string hint = "", Exception? cause = null) =>
        new($"cannot write {path}: {reason}{hint}", cause) { NamesFile = true };
}
