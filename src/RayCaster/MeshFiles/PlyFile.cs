namespace RayCaster;

/// <summary>PLY, ascii or binary: x, y and z of the element vertex, vertex_indices of the element face; all else is skipped.</summary>
internal static class PlyFile
{
    public static MeshData Read(MeshSource source)
    {
        var header = new PlyHeader(source);
        PlyValues values = header.Format == "ascii"
            ? new AsciiPlyValues(source, header.BodyAt)
            : new BinaryPlyValues(source, header.BodyAt, bigEndian: header.Format == "binary_big_endian");
        var mesh = new MeshBuilder(source);
        foreach (var element in header.Elements)
        {
            if (element.Properties.Count == 0) continue; // its rows, however many, take no space
            if (!values.CanHold(element))
                throw source.ErrorAtLine(element.At, $"the header promises {element.Count} rows, more than the rest of the file can hold");
            if (element.Name == "vertex") mesh.ReserveVertices((int)element.Count);
            if (element.Name == "face") mesh.ReserveTriangles((int)element.Count);
            for (var row = 0L; row < element.Count; row++)
            {
                values.BeginRow();
                ReadRow(values, element, header.VertexCount, mesh);
                values.EndRow();
            }
        }
        return mesh.ToMesh();
    }

    private static void ReadRow(PlyValues values, PlyElement element, long vertexCount, MeshBuilder mesh)
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
                case PlyRole.Corners: ReadFace(values, property.Type, count, vertexCount, mesh); break;
                default: values.Skip(property, count); break;
            }
        }
        if (element.Name == "vertex") mesh.AddVertex(new(x, y, z));
    }

    private static void ReadFace(PlyValues values, PlyType type, long count, long vertexCount, MeshBuilder mesh)
    {
        if (count < 3) throw values.Error($"a face needs at least three corners, but this one has {count}");
        mesh.BeginFace();
        for (; count > 0; count--)
        {
            var index = values.Next(type);
            if (index < 0 || index != Math.Floor(index)) throw values.Error($"a face index must be a whole number from 0 on, but is {index}");
            if (index >= vertexCount)
                throw values.Error($"face index {index} is beyond the file's {vertexCount} vertices, which count from 0");
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
