namespace RayCaster.Files;

/// <summary>Reads the numbers in the rows of a PLY file, one after another.</summary>
internal abstract class PlyValues(MeshSource source)
{
    protected MeshSource Source => source;

    public abstract double Next(PlyType type);

    public abstract void Skip(PlyProperty property, long count);

    public virtual void BeginRow() { }

    public virtual void EndRow() { }

    /// <summary>After the last row there may be nothing but blanks: anything else was meant to be part of the mesh.</summary>
    public abstract void CheckEnd();

    /// <summary>The line or byte at which the row begins.</summary>
    public long Place { get; protected set; }

    /// <summary>A mistake in the last number.</summary>
    public abstract ProblemException Error(string reason);

    protected const string TooShort = "the file ends before all that its header promises";

    protected const string TooLong = "there is more in the file than the rows that its header promises";
}

/// <summary>Numbers as text. Each row begins on a line of its own, and may go on on the next ones.</summary>
internal sealed class AsciiPlyValues(MeshSource source, TextScanner scanner) : PlyValues(source)
{
    public override double Next(PlyType type) => scanner.ToNumber(NextWord(), "the value");

    public override void Skip(PlyProperty property, long count)
    {
        for (; count > 0; count--) NextWord();
    }

    public override void BeginRow()
    {
        if (scanner.Next().IsEmpty) throw scanner.Error(TooShort);
        scanner.Return();
        Place = scanner.LineNumber;
    }

    public override void EndRow()
    {
        if (!scanner.NextInLine().IsEmpty) throw scanner.LineNumber > Place ? TooFew()
            : scanner.Error($"the line has more numbers than the header promises, from {scanner.Quoted} on");
        scanner.NextLine();
    }

    public override void CheckEnd()
    {
        while (scanner.Next() is { IsEmpty: false } word)
            if (word.ContainsAnyExcept((byte)0)) throw scanner.Error(TooLong);
    }

    public override ProblemException Error(string reason) => scanner.Error(reason);

    private ReadOnlySpan<byte> NextWord()
    {
        var word = scanner.NextInLine();
        if (word.IsEmpty) word = scanner.Next();
        return word.IsEmpty ? throw TooFew() : word;
    }

    private ProblemException TooFew() => Source.ErrorAtLine((int)Place, "the line has fewer numbers than the header promises");
}

internal sealed class BinaryPlyValues(MeshSource source, bool isBigEndian) : PlyValues(source)
{
    private long last; // where the last number begins

    public override void BeginRow() => Place = Source.Position;

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public override double Next(PlyType type)
    {
        last = Source.Position;
        var size = PlyProperty.Sizes[(int)type];
        if (!Source.Has(size)) throw Error(TooShort);
        var value = Number(Source.Take(size), type, isBigEndian);
        return double.IsFinite(value) ? value : throw Error($"the value must be a finite number, but is {value}");
    }

    public override void Skip(PlyProperty property, long count)
    {
        last = Source.Position;
        if (count > (Source.Length - last) / property.Size) throw Error(TooShort);
        Source.Skip(count * property.Size);
    }

    public override void CheckEnd()
    {
        do
        {
            if (Source.Bytes.IndexOfAnyExcept(" \t\r\n\v\f\0"u8) is >= 0 and var rest) throw Source.ErrorAtByte(Source.Position + rest, TooLong);
            Source.Skip(Source.Bytes.Length);
        }
        while (Source.Load());
    }

    public override ProblemException Error(string reason) => Source.ErrorAtByte(last, reason);

    private static double Number(ReadOnlySpan<byte> bytes, PlyType type, bool isBigEndian) => type switch
    {
        PlyType.Int8 => (sbyte)bytes[0],
        PlyType.UInt8 => bytes[0],
        PlyType.Int16 => isBigEndian ? BinaryPrimitives.ReadInt16BigEndian(bytes) : BinaryPrimitives.ReadInt16LittleEndian(bytes),
        PlyType.UInt16 => isBigEndian ? BinaryPrimitives.ReadUInt16BigEndian(bytes) : BinaryPrimitives.ReadUInt16LittleEndian(bytes),
        PlyType.Int32 => isBigEndian ? BinaryPrimitives.ReadInt32BigEndian(bytes) : BinaryPrimitives.ReadInt32LittleEndian(bytes),
        PlyType.UInt32 => isBigEndian ? BinaryPrimitives.ReadUInt32BigEndian(bytes) : BinaryPrimitives.ReadUInt32LittleEndian(bytes),
        PlyType.Float32 => isBigEndian ? BinaryPrimitives.ReadSingleBigEndian(bytes) : BinaryPrimitives.ReadSingleLittleEndian(bytes),
        _ => isBigEndian ? BinaryPrimitives.ReadDoubleBigEndian(bytes) : BinaryPrimitives.ReadDoubleLittleEndian(bytes),
    };
}
