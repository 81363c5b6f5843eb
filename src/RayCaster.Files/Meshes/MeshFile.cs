namespace RayCaster.Files;

/// <summary>Reads meshes that other programs write.</summary>
public static class MeshFile
{
    /// <summary>The longest line or row, and the longest mesh from a pipe, in bytes: these are in memory as a whole.</summary>
    public const int MaxBytesAtOnce = 1 << 28;

    /// <summary>Reads a mesh file; its extension, in any case, says whether it is OBJ, PLY or STL.</summary>
    /// <param name="names">Suggests names for the missing ones of many files.</param>
    /// <exception cref="ProblemException">The file is not there, is of another kind, or is broken.</exception>
    internal static MeshData Read(string path, FileNames? names = null)
    {
        var reader = ReaderOf(path);
        using var stream = Open(path, names ?? new());
        var source = new MeshSource(path, stream);
        return source.Length > 0 ? reader(source) : throw source.Error("the file is empty");
    }

    internal static bool IsNamedLikeOne(string path) => Path.GetExtension(path).ToLowerInvariant() is ".obj" or ".ply" or ".stl";

    /// <exception cref="ProblemException">The extension names no kind of mesh file.</exception>
    internal static Func<MeshSource, MeshData> ReaderOf(string path) => Path.GetExtension(path).ToLowerInvariant() switch
    {
        ".obj" => ObjFile.Read,
        ".ply" => PlyFile.Read,
        ".stl" => StlFile.Read,
        "" => throw new ProblemException($"{path}: a mesh file's name must end with .obj, .ply or .stl, but this one has no extension"),
        var other => throw new ProblemException($"{path}: a mesh file must be .obj, .ply or .stl, but this one is {other}"),
    };

    private static Stream Open(string path, FileNames names)
    {
        try
        {
            if (Directory.Exists(path)) throw new ProblemException($"{path}: is a folder, not a mesh file");
            var file = new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete, bufferSize: 0);
            if (file.CanSeek && file.Length > 0) return file;
            using (file) return Copy(file, path); // a pipe, or a file like those in /proc, which seem to be empty
        }
        catch (Exception e) when (e is FileNotFoundException or DirectoryNotFoundException)
        {
            throw new ProblemException($"{path}: file not found{names.Hint(path)}", e);
        }
        catch (UnauthorizedAccessException e)
        {
            var place = Path.IsPathFullyQualified(path) ? "" : $"; looked for {PrintableText.Of(Path.GetFullPath(path))}";
            throw new ProblemException($"{path}: no permission to read it{place}", e);
        }
        catch (Exception e) when (e is IOException or ArgumentException or NotSupportedException)
        {
            throw new ProblemException($"{path}: cannot be read: {e.Message}", e);
        }
    }

    private static MemoryStream Copy(Stream stream, string path) => InputBytes.TryReadToEnd(stream, MaxBytesAtOnce, out var bytes)
        ? new(bytes.Array!, 0, bytes.Count, writable: false)
        : throw new ProblemException(FormattableString.Invariant(
            $"{path}: a pipe or device of more than {MaxBytesAtOnce:N0} bytes is not read, but a file of any size is"));
}
