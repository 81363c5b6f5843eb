using System.Buffers.Binary;
using System.Runtime.CompilerServices;

namespace RayCaster.Files;

/// <summary>How the rows of a PLY file follow one another: what tells where one ends, without reading what it says.</summary>
internal abstract class PlyRows
{
    /// <summary>Whether some bytes can be as many rows of an element as the header promises, the shortest that there can be.</summary>
    public abstract bool CanHold(PlyElement element, long bytes);

    /// <summary>The length of the rows that are whole.</summary>
    /// <param name="bytes">Some of the rest of the file, from the beginning of a row on.</param>
    /// <param name="element">What the rows are.</param>
    /// <param name="count">At first how many rows are wanted, at last how many there are.</param>
    public abstract int Measure(ReadOnlySpan<byte> bytes, PlyElement element, ref long count);

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

    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public override int Measure(ReadOnlySpan<byte> bytes, PlyElement element, ref long count)
    {
        var (wanted, rowsEnd, at) = (count, 0, 0);
        for (count = 0; count < wanted;)
        {
            var line = bytes[at..];
            var end = line.IndexOfAny((byte)'\n', (byte)'\r');
            if (end < 0) break;
            at += end + 1;
            if (line[end] == '\r')
            {
                if (at == bytes.Length) break; // an LF may follow that belongs to the same line end
                if (bytes[at] == '\n') at++;
            }
            if (!line[..end].ContainsAnyExcept(" \t\v\f"u8)) continue;
            rowsEnd = at;
            count++;
        }
        return rowsEnd;
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

    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public override int Measure(ReadOnlySpan<byte> bytes, PlyElement element, ref long count)
    {
        var (wanted, rowsEnd) = (count, 0L);
        for (count = 0; count < wanted; count++)
        {
            var at = rowsEnd;
            foreach (var property in element.Properties)
            {
                if (property.CountType is not { } type)
                {
                    at += property.Size;
                    continue;
                }
                if (at + PlyProperty.SizeOf(type) > bytes.Length) return (int)rowsEnd;
                // A count below 0 is refused when the row is read.
                at += PlyProperty.SizeOf(type) + Math.Max(0, Count(bytes[(int)at..], type)) * property.Size;
            }
            if (at > bytes.Length) break;
            rowsEnd = at;
        }
        return (int)rowsEnd;
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
