namespace RayCaster.Files;

/// <summary>Reads meshes that other programs write.</summary>
internal static class MeshFile
{
    /// <summary>The longest line or row, and the longest mesh from a pipe, in bytes: these are in memory as a whole.</summary>
    public const int MaxBytesAtOnce = 1 << 28;

    internal static MeshData Read(string path, MissingFileHint? names = null)
    {
        var reader = ReaderOf(path);
        try
        {
            using var file = InputFile.Open(path, "mesh file", names);
            // A pipe is copied, and a file like those in /proc, which seem to be empty.
            using Stream stream = file.CanSeek && file.Length > 0 ? file : Copy(file);
            var source = new MeshSource(path, stream);
            return source.Length > 0 ? reader(source) : throw source.Error("the file is empty");
        }
        catch (Exception e) when (e is IOException or ProblemException { NamesFile: false })
        {
            throw new ProblemException($"{PrintableText.Escaped(path)}: {(e is IOException ? ProblemException.Reason(e) : e.Message)}", e);
        }
    }

    internal static bool IsNamedLikeOne(string path) => Path.GetExtension(path).ToLowerInvariant() is ".obj" or ".ply" or ".stl";

    internal static Func<MeshSource, MeshData> ReaderOf(string path) => Path.GetExtension(path).ToLowerInvariant() switch
    {
        ".obj" => ObjFile.Read,
        ".ply" => PlyFile.Read,
        ".stl" => StlFile.Read,
        "" => throw new ProblemException($"{path}: a mesh file's name must end with .obj, .ply or .stl, but this one has no extension"),
        var other => throw new ProblemException($"{path}: a mesh file must be .obj, .ply or .stl, but this one is {other}"),
    };

    private static MemoryStream Copy(Stream stream)
    {
        var bytes = InputFile.ReadToEnd(stream, "pipe or device", MaxBytesAtOnce, "; a file may have any size");
        return new(bytes.Array!, 0, bytes.Count, writable: false);
    }
}
