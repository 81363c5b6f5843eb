using System.Buffers.Binary;

namespace RayCaster;

/// <summary>The numbers of a PLY file after its header, one after another, however they are written.</summary>
internal abstract class PlyValues
{
    /// <summary>Reads one number; it is finite.</summary>
    public abstract double Next(PlyType type);

    /// <summary>Passes numbers by without looking at them.</summary>
    public abstract void Skip(PlyProperty property, long count);

    /// <summary>Whether the rest of the file is long enough for the rows that the header promises, the shortest that there can be.</summary>
    public abstract bool CanHold(PlyElement element);

    /// <summary>Goes to the next row of an element.</summary>
    public abstract void BeginRow();

    /// <summary>Leaves the row.</summary>
    public abstract void EndRow();

    /// <summary>A mistake in the last number.</summary>
    public abstract MeshFileException Error(string reason);
}

/// <summary>Numbers as text, each row on a line of its own.</summary>
internal sealed class AsciiPlyValues(MeshSource source, int position) : PlyValues
{
    private readonly TextScanner scanner = new(source, position);

    public override double Next(PlyType type) => scanner.ToNumber(NextWord(), "the value");

    public override void Skip(PlyProperty property, long count)
    {
        for (; count > 0; count--) NextWord();
    }

    public override bool CanHold(PlyElement element)
    {
        var leastRow = 0L;
        foreach (var property in element.Properties) leastRow += 2 * property.LeastNumbers; // each a digit and a blank or line end
        return element.Count <= (source.Bytes.Length - scanner.Position + 1) / leastRow;    // the last may go without
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

    public override MeshFileException Error(string reason) => scanner.Error(reason);

    private ReadOnlySpan<byte> NextWord()
    {
        var word = scanner.NextInLine();
        return word.IsEmpty ? throw scanner.Error("the line has fewer numbers than the header promises") : word;
    }
}

/// <summary>Numbers as bytes, the least first or the greatest first.</summary>
internal sealed class BinaryPlyValues(MeshSource source, int position, bool bigEndian) : PlyValues
{
    private readonly byte[] bytes = source.Bytes;
    private int position = position, last = position;

    public override double Next(PlyType type)
    {
        var at = bytes.AsSpan(last = position);
        position += new PlyProperty(PlyRole.Skipped, type, null).Size;
        if (position > bytes.Length) throw TooShort();
        var value = type switch
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
        return double.IsFinite(value) ? value : throw Error($"the value must be a finite number, but is {value}");
    }

    public override void Skip(PlyProperty property, long count)
    {
        last = position;
        if (count > (bytes.Length - position) / property.Size) throw TooShort();
        position += (int)count * property.Size;
    }

    public override bool CanHold(PlyElement element)
    {
        var leastRow = 0L;
        foreach (var property in element.Properties) leastRow += property.LeastSize;
        return element.Count <= (bytes.Length - position) / leastRow;
    }

    public override void BeginRow() { }

    public override void EndRow() { }

    public override MeshFileException Error(string reason) => source.ErrorAtByte(last, reason);

    private MeshFileException TooShort() => Error("the file ends before all that its header promises");
}
