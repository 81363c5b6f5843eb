namespace RayCaster.Files;

/// <summary>PLY, ascii or binary: x, y and z of the element vertex, vertex_indices of the element face; all else is skipped.</summary>
internal sealed class PlyFile(MeshSource source, PlyHeader header) : MeshFormat(source, header.BodyAt)
{
    private readonly bool isAscii = header.Format == "ascii", isBigEndian = header.Format == "binary_big_endian";
    private long rowsLeft, rowCount; // of the last element that has begun, and in the last block
    private int elementsBegun;

    public static MeshData Read(MeshSource source)
    {
        var header = new PlyHeader(source);
        return TrianglePly.Read(source, header) ?? MeshReader.Read(source, () => new PlyFile(source, header));
    }

    /// <summary>A block has rows of one element.</summary>
    public override bool Next(MeshBlock block)
    {
        for (; rowsLeft == 0; elementsBegun++)
        {
            if (elementsBegun == header.Elements.Count)
            {
                CheckRest();
                return false;
            }
            Begin(header.Elements[elementsBegun]);
        }

        Position = block.Load(Position, this).End;
        rowsLeft -= rowCount;
        (block.Element, block.RowCount) = (Element, rowCount);
        return true;
    }

    public override void Read(MeshBlock block, MeshBuilder mesh)
    {
        PlyValues values = isAscii ? new AsciiPlyValues(block) : new BinaryPlyValues(block, isBigEndian);
        for (var row = 0L; row < block.RowCount; row++)
        {
            values.BeginRow();
            ReadRow(values, block.Element!, mesh);
            values.EndRow();
        }
    }

    public override int Cut(ReadOnlySpan<byte> bytes, bool isEnd)
    {
        var length = isAscii ? AsciiPlyValues.Measure(bytes, rowsLeft, out rowCount)
            : BinaryPlyValues.Measure(bytes, Element, isBigEndian, rowsLeft, out rowCount);
        if (!isEnd || rowCount == rowsLeft) return length;
        rowCount = rowsLeft; // in ascii the last line may have no end; rows that are missing are an error when they are read
        return bytes.Length;
    }

    private PlyElement Element => header.Elements[elementsBegun - 1];

    private void Begin(PlyElement element)
    {
        if (element.Properties.Count == 0) return; // its rows take no space
        var leastRow = element.Properties.Sum(property => isAscii ? 2L * property.LeastNumbers : property.LeastSize);
        // In ascii each number has a digit, and a blank or line end; the last line may have no end.
        if (element.Count > (Source.Length - Position + (isAscii ? 1 : 0)) / leastRow)
            throw Source.ErrorAtLine(element.At, $"the header promises {element.Count} rows, more than the rest of the file can hold");
        rowsLeft = element.Count;
    }

    /// <summary>After the last row there may be nothing but blanks: anything else was meant to be part of the mesh.</summary>
    private void CheckRest()
    {
        if (Source.FirstNotBlank(Position) is not { } rest) return;
        const string reason = "there is more in the file than the rows that its header promises";
        throw isAscii ? Source.ErrorAtLine(rest, reason) : Source.ErrorAtByte(rest, reason);
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void ReadRow(PlyValues values, PlyElement element, MeshBuilder mesh)
    {
        var (x, y, z) = (0d, 0d, 0d);
        foreach (var property in element.Properties)
        {
            var count = property.CountType is { } type ? ReadCount(values, type) : 1;
            switch (property.Role)
            {
                case PlyRole.X: x = values.Next(property.Type); break;
                case PlyRole.Y: y = values.Next(property.Type); break;
                case PlyRole.Z: z = values.Next(property.Type); break;
                case PlyRole.Corners: ReadFace(values, property.Type, count, mesh); break;
                default: values.Skip(property, count); break;
            }
        }
        if (element.Name == "vertex") mesh.AddVertex(new(x, y, z));
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void ReadFace(PlyValues values, PlyType type, long count, MeshBuilder mesh)
    {
        if (count < 3) throw values.Error($"a face needs at least three corners, but this one has {count}");
        mesh.BeginFace();
        mesh.Expect(Math.Min(count, values.MostLeft) - 2);
        for (; count > 0; count--)
        {
            var index = values.Next(type);
            if (index < 0 || index != Math.Floor(index)) throw values.Error($"a face index must be a whole number from 0 on, but is {index}");
            if (index >= header.VertexCount)
                throw values.Error($"face index {index} is beyond the file's {header.VertexCount} vertices, which count from 0");
            mesh.AddCorner((int)index);
        }
    }

    private static long ReadCount(PlyValues values, PlyType type)
    {
        var count = values.Next(type);
        if (count < 0 || count != Math.Floor(count)) throw values.Error($"the count of a list must be a whole number from 0 on, but is {count}");
        return (long)count;
    }
}
