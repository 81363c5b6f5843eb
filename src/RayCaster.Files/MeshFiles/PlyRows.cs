using System.Runtime.CompilerServices;

namespace RayCaster.Files;

/// <summary>Finds where the rows of a PLY file end, without reading their values.</summary>
internal abstract class PlyRows
{
    /// <summary>Whether some bytes can hold all rows of an element that the header promises, if each row is as short as possible.</summary>
    public abstract bool CanHold(PlyElement element, long bytes);

    /// <summary>The length of the rows that are whole.</summary>
    /// <param name="bytes">Some of the file, from the beginning of a row on.</param>
    /// <param name="count">In: how many rows are wanted. Out: how many there are.</param>
    public abstract int Measure(ReadOnlySpan<byte> bytes, PlyElement element, ref long count);

    public abstract PlyValues ValuesOf(MeshBlock block);
}

/// <summary>Each row is a line; blank lines do not count.</summary>
internal sealed class AsciiPlyRows : PlyRows
{
    public override bool CanHold(PlyElement element, long bytes)
    {
        var leastRow = 0L;
        foreach (var property in element.Properties) leastRow += 2 * property.LeastNumbers; // each a digit, and a blank or line end
        return element.Count <= (bytes + 1) / leastRow;                                    // the last line may have no end
    }

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
                if (at == bytes.Length) break; // the next byte may be an LF of the same line end
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

/// <summary>A row ends where the lists in it say.</summary>
internal sealed class BinaryPlyRows(bool bigEndian) : PlyRows
{
    public override bool CanHold(PlyElement element, long bytes)
    {
        var leastRow = 0L;
        foreach (var property in element.Properties) leastRow += property.LeastSize;
        return element.Count <= bytes / leastRow;
    }

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
                at += PlyProperty.SizeOf(type) + Math.Max(0, (long)BinaryPlyValues.Number(bytes[(int)at..], type, bigEndian)) * property.Size;
            }
            if (at > bytes.Length) break;
            rowsEnd = at;
        }
        return (int)rowsEnd;
    }

    public override PlyValues ValuesOf(MeshBlock block) => new BinaryPlyValues(block, bigEndian);
}
