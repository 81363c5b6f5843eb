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
    private readonly TextScanner scanner = new(block, position: 0);

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

    public override void Skip(PlyProperty property, long count)
    {
        last = position;
        if (count > (length - position) / property.Size) throw TooShort();
        position += (int)count * property.Size;
    }

    public override MeshFileException Error(string reason) => block.Source.ErrorAtByte(block.Start + last, reason);

    private MeshFileException TooShort() => Error("the file ends before all that its header promises");
}
