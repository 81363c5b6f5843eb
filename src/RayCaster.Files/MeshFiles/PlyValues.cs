namespace RayCaster.Files;

/// <summary>Reads the numbers in some rows of a PLY file, one after another.</summary>
internal abstract class PlyValues
{
    /// <exception cref="MeshFileException">It is missing or not finite.</exception>
    public abstract double Next(PlyType type);

    public abstract void Skip(PlyProperty property, long count);

    /// <summary>An upper limit of the numbers that are left, whatever a count in the file says.</summary>
    public abstract long MostLeft { get; }

    public virtual void BeginRow() { }

    public virtual void EndRow() { }

    /// <summary>A mistake in the last number.</summary>
    public abstract MeshFileException Error(string reason);
}

/// <summary>Numbers as text, each row on a line of its own.</summary>
internal sealed class AsciiPlyValues(MeshBlock block) : PlyValues
{
    private readonly TextScanner scanner = new(block);

    public override long MostLeft => (block.Length - scanner.Position + 1L) / 2; // each a digit and a blank

    public override double Next(PlyType type) => scanner.ToNumber(NextWord(), "the value");

    public override void Skip(PlyProperty property, long count)
    {
        for (; count > 0; count--) NextWord();
    }

    public override void BeginRow()
    {
        while (scanner.NextInLine().IsEmpty)
            if (!scanner.NextLine()) throw scanner.Error("the file ends before all that its header promises");
        scanner.Position = scanner.WordAt;
    }

    public override void EndRow()
    {
        if (!scanner.NextInLine().IsEmpty) throw scanner.Error($"the line has more numbers than the header promises, from {scanner.Quoted} on");
        scanner.NextLine();
    }

    /// <summary>The length of the rows that are whole, each of which is a line; blank lines do not count.</summary>
    /// <param name="bytes">Some of the file, from the beginning of a row on.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public static int Measure(ReadOnlySpan<byte> bytes, long wanted, out long count)
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

    public override MeshFileException Error(string reason) => scanner.Error(reason);

    private ReadOnlySpan<byte> NextWord()
    {
        var word = scanner.NextInLine();
        return word.IsEmpty ? throw scanner.Error("the line has fewer numbers than the header promises") : word;
    }
}

internal sealed class BinaryPlyValues(MeshBlock block, bool bigEndian) : PlyValues
{
    private readonly byte[] buffer = block.Buffer;
    private readonly int length = block.Length;
    private int position, last;

    public override long MostLeft => length - position;

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public override double Next(PlyType type)
    {
        last = position;
        var size = PlyProperty.SizeOf(type);
        if (size > length - position) throw TooShort();
        var at = buffer.AsSpan(position, size);
        position += size;
        var value = Number(at, type, bigEndian);
        return double.IsFinite(value) ? value : throw Error($"the value must be a finite number, but is {value}");
    }

    /// <summary>The number that begins at the first of some bytes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Number(ReadOnlySpan<byte> at, PlyType type, bool bigEndian) => type switch
    {
        PlyType.Int8 => (sbyte)at[0],
        PlyType.UInt8 => at[0],
        PlyType.Int16 => bigEndian ? BinaryPrimitives.ReadInt16BigEndian(at) : BinaryPrimitives.ReadInt16LittleEndian(at),
        PlyType.UInt16 => bigEndian ? BinaryPrimitives.ReadUInt16BigEndian(at) : BinaryPrimitives.ReadUInt16LittleEndian(at),
        PlyType.Int32 => bigEndian ? BinaryPrimitives.ReadInt32BigEndian(at) : BinaryPrimitives.ReadInt32LittleEndian(at),
        PlyType.UInt32 => bigEndian ? BinaryPrimitives.ReadUInt32BigEndian(at) : BinaryPrimitives.ReadUInt32LittleEndian(at),
        PlyType.Float32 => bigEndian ? BinaryPrimitives.ReadSingleBigEndian(at) : BinaryPrimitives.ReadSingleLittleEndian(at),
        _ => bigEndian ? BinaryPrimitives.ReadDoubleBigEndian(at) : BinaryPrimitives.ReadDoubleLittleEndian(at),
    };

    /// <summary>The length of the rows that are whole: a row ends where the lists in it say.</summary>
    /// <param name="bytes">Some of the file, from the beginning of a row on.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public static int Measure(ReadOnlySpan<byte> bytes, PlyElement element, bool bigEndian, long wanted, out long count)
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
                at += PlyProperty.SizeOf(type) + Math.Max(0, (long)Number(bytes[(int)at..], type, bigEndian)) * property.Size;
            }
            if (at > bytes.Length) break;
            rowsEnd = at;
        }
        return (int)rowsEnd;
    }

    public override void Skip(PlyProperty property, long count)
    {
        last = position;
        if (count > (length - position) / property.Size) throw TooShort();
        position += (int)count * property.Size;
    }

    public override MeshFileException Error(string reason) => block.Source.ErrorAtByte(block.Start + last, reason);

    private MeshFileException TooShort() => Error("the file ends before all that its header promises");
}
