namespace RayCaster.Files;

/// <summary>Finds where the rows of a PLY file end, without reading their values.</summary>
internal static class PlyRows
{
    /// <summary>Whether some bytes can hold all rows of an element that the header promises, if each row is as short as possible.</summary>
    public static bool CanHold(PlyElement element, long bytes, bool isAscii)
    {
        var leastRow = 0L;
        foreach (var property in element.Properties) leastRow += isAscii ? 2 * property.LeastNumbers : property.LeastSize;
        // In ascii each number has a digit, and a blank or line end; the last line may have no end.
        return element.Count <= (isAscii ? bytes + 1 : bytes) / leastRow;
    }

    /// <summary>The length of the rows that are whole, in ascii: each row is a line, and blank lines do not count.</summary>
    /// <param name="bytes">Some of the file, from the beginning of a row on.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public static int MeasureLines(ReadOnlySpan<byte> bytes, long wanted, out long count)
    {
        var (rowsEnd, at) = (0, 0);
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

    /// <summary>The same in binary form: a row ends where the lists in it say.</summary>
    /// <inheritdoc cref="MeasureLines"/>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public static int MeasureBinary(ReadOnlySpan<byte> bytes, PlyElement element, bool bigEndian, long wanted, out long count)
    {
        var rowsEnd = 0L;
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
}
