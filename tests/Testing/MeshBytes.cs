namespace RayCaster.Testing;

/// <summary>Reads mesh files that are in memory.</summary>
public static class MeshBytes
{
    /// <param name="path">The file's name, for its extension and for messages.</param>
    /// <param name="pieceSize">How many bytes are read at once; by default as many as of a file.</param>
    public static MeshData Read(string path, byte[] bytes, int pieceSize = 1 << 20) =>
        MeshFile.ReaderOf(path)(new MeshSource(path, new MemoryStream(bytes, writable: false), pieceSize));
}
