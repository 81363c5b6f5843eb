namespace RayCaster.Files;

/// <summary>Reads meshes that other programs write.</summary>
public static class MeshFile
{
    /// <summary>The longest line or row, and the longest mesh from a pipe, in bytes: these are in memory as a whole.</summary>
    public const int MostBytesAtOnce = 1 << 28;

    /// <summary>Reads a mesh file; its extension, in any case, says whether it is OBJ, PLY or STL.</summary>
    /// <param name="threads">How many threads read a large file; one per core if left out.</param>
    /// <param name="names">Suggests names for the missing ones of many files.</param>
    /// <exception cref="MeshFileException">The file is not there, is of another kind, or is broken.</exception>
    internal static MeshData Read(string path, int? threads = null, FileNames? names = null)
    {
        var reader = ReaderOf(path);
        using var stream = Open(path, names ?? new());
        return reader(new MeshSource(path, stream, threads: threads ?? Environment.ProcessorCount));
    }

    internal static bool IsNamedLikeOne(string path) => Path.GetExtension(path).ToLowerInvariant() is ".obj" or ".ply" or ".stl";

    /// <exception cref="MeshFileException">The extension names no kind of mesh file.</exception>
    internal static Func<MeshSource, MeshData> ReaderOf(string path) => Path.GetExtension(path).ToLowerInvariant() switch
    {
        ".obj" => ObjFile.Read,
        ".ply" => PlyFile.Read,
        ".stl" => StlFile.Read,
        "" => throw new MeshFileException(path, "a mesh file's name must end with .obj, .ply or .stl, but this one has no extension"),
        var other => throw new MeshFileException(path, $"a mesh file must be .obj, .ply or .stl, but this one is {other}"),
    };

    private static Stream Open(string path, FileNames names)
    {
        try
        {
            if (Directory.Exists(path)) throw new MeshFileException(path, "is a folder, not a mesh file");
            var file = new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.Read, bufferSize: 0);
            if (file.CanSeek && file.Length > 0) return file;
            using (file) return Copy(file, path); // a pipe, or a file like those in /proc, which seem to be empty
        }
        catch (Exception e) when (e is FileNotFoundException or DirectoryNotFoundException)
        {
            throw new MeshFileException(path, $"file not found{names.Hint(path)}", inner: e);
        }
        catch (UnauthorizedAccessException e)
        {
            var place = Path.IsPathFullyQualified(path) ? "" : $"; looked for {PrintableText.Of(Path.GetFullPath(path))}";
            throw new MeshFileException(path, $"no permission to read it{place}", inner: e);
        }
        catch (Exception e) when (e is IOException or ArgumentException or NotSupportedException)
        {
            throw new MeshFileException(path, $"cannot be read: {e.Message}", inner: e);
        }
    }

    private static MemoryStream Copy(Stream stream, string path) => InputBytes.TryReadToEnd(stream, MostBytesAtOnce, out var bytes)
        ? new(bytes.Array!, 0, bytes.Count, writable: false)
        : throw new MeshFileException(path, FormattableString.Invariant(
            $"a pipe or device of more than {MostBytesAtOnce:N0} bytes is not read, but a file of any size is"));
}
