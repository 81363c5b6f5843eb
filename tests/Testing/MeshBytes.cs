namespace RayCaster.Testing;

/// <summary>Reads mesh files that are in memory.</summary>
public static class MeshBytes
{
    /// <param name="path">The file's name, for its extension and for messages.</param>
    /// <param name="blockSize">How many bytes are read at once; by default as many as of a file.</param>
    public static MeshData Read(string path, byte[] bytes, int blockSize = MeshSource.UsualBlockSize, int threads = 1) =>
        MeshFile.ReaderOf(path)(new MeshSource(path, new MemoryStream(bytes, writable: false), blockSize, threads));
}
