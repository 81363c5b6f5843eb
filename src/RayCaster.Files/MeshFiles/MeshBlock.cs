namespace RayCaster.Files;

/// <summary>A part of a mesh file that can be read by itself, since it begins and ends between two statements, rows or facets.</summary>
/// <param name="source">The file.</param>
internal sealed class MeshBlock(MeshSource source)
{
    /// <summary>Finds where a block can end.</summary>
    /// <param name="bytes">What has been loaded.</param>
    /// <param name="isEnd">Whether the file ends there.</param>
    /// <returns>The bytes of the block; 0 where more must be loaded first.</returns>
    public delegate int Cut(ReadOnlySpan<byte> bytes, bool isEnd);

    public MeshSource Source => source;

    /// <summary>Where the block begins in the file.</summary>
    public long Start { get; private set; }

    /// <summary>The bytes of the block, from place 0 of <see cref="Buffer"/> on.</summary>
    public int Length { get; private set; }

    /// <summary>Holds the block, and behind it bytes that mean nothing.</summary>
    public byte[] Buffer { get; private set; } = [];

    public ReadOnlySpan<byte> Bytes => Buffer.AsSpan(0, Length);

    /// <summary>In PLY, what the rows of the block are.</summary>
    public PlyElement? Element { get; set; }

    /// <summary>In PLY, how many rows the block has.</summary>
    public long RowCount { get; set; }

    /// <summary>Where the next block begins.</summary>
    public long End => Start + Length;

    /// <summary>Whether the file ends with this block.</summary>
    public bool IsLast => End == source.Length;

    /// <summary>Loads a block of the usual size; a longer one where the usual size has no place to cut.</summary>
    /// <exception cref="MeshFileException">The file cannot be read, or has no place to cut in <see cref="MeshFile.MostBytesAtOnce"/>.</exception>
    public MeshBlock Load(long start, Cut cut)
    {
        var rest = source.Length - start;
        for (var size = (long)source.BlockSize; ; size *= 2)
        {
            Load(start, (int)Math.Min(rest, Math.Min(size, MeshFile.MostBytesAtOnce)));
            var isEnd = Length == rest;
            Length = cut(Bytes, isEnd);
            if (Length > 0 || isEnd) return this;
            if (size >= MeshFile.MostBytesAtOnce)
                throw source.ErrorAtByte(start, FormattableString.Invariant(
                    $"a line or row begins here that has more than {MeshFile.MostBytesAtOnce:N0} bytes, which is the limit"));
        }
    }

    /// <summary>Loads a block of a given length.</summary>
    /// <exception cref="MeshFileException">The file cannot be read.</exception>
    public MeshBlock Load(long start, int length)
    {
        if (Buffer.Length < length) Buffer = GC.AllocateUninitializedArray<byte>(length);
        source.Read(start, Buffer.AsSpan(0, length));
        (Start, Length) = (start, length);
        return this;
    }
}
