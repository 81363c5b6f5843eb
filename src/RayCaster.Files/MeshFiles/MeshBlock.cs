namespace RayCaster.Files;

/// <summary>A part of a mesh file that begins and ends between two statements, rows or facets, so that it can be read by itself.</summary>
internal sealed class MeshBlock(MeshSource source)
{
    public MeshSource Source => source;

    public long Start { get; private set; }

    public int Length { get; private set; }

    /// <summary>The block, and after its <see cref="Length"/> bytes old ones without a meaning.</summary>
    public byte[] Buffer { get; private set; } = [];

    public ReadOnlySpan<byte> Bytes => Buffer.AsSpan(0, Length);

    /// <summary>In PLY, what the rows of the block are.</summary>
    public PlyElement? Element { get; set; }

    /// <summary>In PLY, how many rows the block has.</summary>
    public long RowCount { get; set; }

    public long End => Start + Length;

    public bool IsLast => End == source.Length;

    /// <summary>Loads a block of the usual size, or a longer one if that has no place to cut.</summary>
    /// <exception cref="MeshFileException">The file cannot be read, or has no place to cut in <see cref="MeshFile.MostBytesAtOnce"/>.</exception>
    public MeshBlock Load(long start, MeshFormat format)
    {
        var rest = source.Length - start;
        for (var size = (long)source.BlockSize; ; size *= 2)
        {
            Load(start, (int)Math.Min(rest, Math.Min(size, MeshFile.MostBytesAtOnce)));
            var isEnd = Length == rest;
            Length = format.Cut(Bytes, isEnd);
            if (Length > 0 || isEnd) return this;
            if (size >= MeshFile.MostBytesAtOnce)
                throw source.ErrorAtByte(start, FormattableString.Invariant(
                    $"a line or row begins here that has more than {MeshFile.MostBytesAtOnce:N0} bytes, which is the limit"));
        }
    }

    public MeshBlock Load(long start, int length)
    {
        if (Buffer.Length < length) Buffer = GC.AllocateUninitializedArray<byte>(length);
        source.Read(start, Buffer.AsSpan(0, length));
        (Start, Length) = (start, length);
        return this;
    }
}
