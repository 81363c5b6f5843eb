using System.Buffers.Binary;

namespace RayCaster;

/// <summary>How the rows of a PLY file follow one another: what tells where one ends, without reading what it says.</summary>
internal abstract class PlyRows
{
    /// <summary>Whether some bytes can be as many rows of an element as the header promises, the shortest that there can be.</summary>
    public abstract bool CanHold(PlyElement element, long bytes);

    /// <summary>The length of the first row; null where its end is not among the bytes.</summary>
    /// <param name="bytes">Some of the rest of the file, from the beginning of a row on.</param>
    /// <param name="element">What the row is one of.</param>
    public abstract int? LengthOfFirst(ReadOnlySpan<byte> bytes, PlyElement element);

    /// <summary>Begins to read the rows of a block.</summary>
    public abstract PlyValues ValuesOf(MeshBlock block);
}

/// <summary>Each row is a line; blank lines do not count.</summary>
internal sealed class AsciiPlyRows : PlyRows
{
    public override bool CanHold(PlyElement element, long bytes)
    {
        var leastRow = 0L;
        foreach (var property in element.Properties) leastRow += 2 * property.LeastNumbers; // each a digit and a blank or line end
        return element.Count <= (bytes + 1) / leastRow;                                    // the last may go without
    }

    public override int? LengthOfFirst(ReadOnlySpan<byte> bytes, PlyElement element)
    {
        for (var at = 0; ;)
        {
            var line = bytes[at..];
            var end = line.IndexOfAny((byte)'\n', (byte)'\r');
            if (end < 0) return null;
            at += end + 1;
            if (line[end] == '\r')
            {
                if (at == bytes.Length) return null; // an LF may follow that belongs to the same line end
                if (bytes[at] == '\n') at++;
            }
            if (line[..end].ContainsAnyExcept(" \t\v\f"u8)) return at;
        }
    }

    public override PlyValues ValuesOf(MeshBlock block) => new AsciiPlyValues(block);
}

/// <summary>Rows have no ends; only the lists in them say how long they are.</summary>
internal sealed class BinaryPlyRows(bool bigEndian) : PlyRows
{
    public override bool CanHold(PlyElement element, long bytes)
    {
        var leastRow = 0L;
        foreach (var property in element.Properties) leastRow += property.LeastSize;
        return element.Count <= bytes / leastRow;
    }

    public override int? LengthOfFirst(ReadOnlySpan<byte> bytes, PlyElement element)
    {
        var length = 0L;
        foreach (var property in element.Properties)
        {
            var count = 1L;
            if (property.CountType is { } type)
            {
                if (length + PlyProperty.SizeOf(type) > bytes.Length) return null;
                count = Math.Max(0, Count(bytes[(int)length..], type)); // one below 0 is refused when the row is read
                length += PlyProperty.SizeOf(type);
            }
            length += count * property.Size;
            if (length > bytes.Length) return null;
        }
        return (int)length;
    }

    public override PlyValues ValuesOf(MeshBlock block) => new BinaryPlyValues(block, bigEndian);

    private long Count(ReadOnlySpan<byte> at, PlyType type) => type switch
    {
        PlyType.Int8 => (sbyte)at[0],
        PlyType.UInt8 => at[0],
        PlyType.Int16 => bigEndian ? BinaryPrimitives.ReadInt16BigEndian(at) : BinaryPrimitives.ReadInt16LittleEndian(at),
        PlyType.UInt16 => bigEndian ? BinaryPrimitives.ReadUInt16BigEndian(at) : BinaryPrimitives.ReadUInt16LittleEndian(at),
        PlyType.Int32 => bigEndian ? BinaryPrimitives.ReadInt32BigEndian(at) : BinaryPrimitives.ReadInt32LittleEndian(at),
        _ => bigEndian ? BinaryPrimitives.ReadUInt32BigEndian(at) : BinaryPrimitives.ReadUInt32LittleEndian(at),
    };
}
