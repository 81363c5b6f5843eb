namespace RayCaster.Files;

/// <summary>
/// Reads a mesh file in blocks, several at once, and joins them in file order. If a block is broken, one thread reads all blocks again in
/// order. So the first mistake is reported, with the number of vertices above it.
/// </summary>
internal static class MeshReader
{
    public static MeshData Read(MeshSource source, Func<MeshFormat> begin)
    {
        var threads = (int)Math.Min(source.Threads, 1 + source.Length / source.BlockSize);
        try
        {
            return Read(source, begin(), threads);
        }
        catch (MeshFileException) when (threads > 1)
        {
            return ReadInOrder(source, begin());
        }
    }

    /// <summary>Reads a file on one thread, so that its first mistake is found.</summary>
    public static MeshData ReadInOrder(MeshSource source, MeshFormat format) => Read(source, format, threads: 1);

    private static MeshData Read(MeshSource source, MeshFormat format, int threads)
    {
        var pieces = new List<MeshPiece>();
        Ranges.EachPiece(threads, threads, _ =>
        {
            var (block, mesh) = (new MeshBlock(source), new MeshBuilder(source, isInOrder: threads == 1));
            while (NextPlace(block) is { } place)
            {
                format.Read(block, mesh);
                var piece = mesh.TakePiece();
                lock (format) pieces[place] = piece;
            }
        });
        return MeshPiece.Join(pieces, source, threads);

        int? NextPlace(MeshBlock block)
        {
            lock (format)
            {
                if (!format.Next(block)) return null;
                pieces.Add(default);
                return pieces.Count - 1;
            }
        }
    }
}
