namespace RayCaster.Files;

/// <summary>PLY, ascii or binary: x, y and z of the element vertex, vertex_indices of the elements face and tristrips; all else is
/// skipped.</summary>
internal sealed class PlyFile(PlyHeader header, PlyValues values, MeshBuilder mesh)
{
    public static MeshData Read(MeshSource source)
    {
        source.ThrowUnless("a PLY mesh");
        var header = new PlyHeader(source);
        var mesh = new MeshBuilder(source);
        PlyValues values = header.Format == "ascii" ? new AsciiPlyValues(source, header.Scanner)
            : new BinaryPlyValues(source, isBigEndian: header.Format == "binary_big_endian");
        var file = new PlyFile(header, values, mesh);
        foreach (var element in header.Elements)
        {
            if (element.Properties.Count == 0) continue; // its rows take no space
            for (var row = 0L; row < element.Count; row++) file.ReadRow(element);
        }
        values.CheckEnd();
        return mesh.Finish(placeName: header.Format == "ascii" ? "in line" : "at byte");
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void ReadRow(PlyElement element)
    {
        values.BeginRow();
        var (x, y, z) = (0d, 0d, 0d);
        foreach (var property in element.Properties)
        {
            var count = property.CountType is { } type ? ReadCount(type) : 1;
            switch (property.Role)
            {
                case PlyRole.X: x = values.Next(property.Type); break;
                case PlyRole.Y: y = values.Next(property.Type); break;
                case PlyRole.Z: z = values.Next(property.Type); break;
                case PlyRole.Corners: ReadFace(property.Type, count); break;
                case PlyRole.Strips: ReadStrips(property.Type, count); break;
                default: values.Skip(property, count); break;
            }
        }
        if (element.Name == "vertex") mesh.AddVertex(new(x, y, z));
        values.EndRow();
    }

    private void ReadFace(PlyType type, long count)
    {
        if (count < 3) throw values.Error($"a face needs at least three corners, but this one has {count}");
        mesh.BeginFace();
        for (; count > 0; count--) mesh.AddCorner(ToCorner(values.Next(type)));
        mesh.EndFace("a face", "corners", values.Place, values.Error);
    }

    /// <summary>Strips, one after another: each corner from the third on makes a triangle with the two before, every other one turned. −1 ends a
    /// strip; a corner that is there twice joins two, by triangles without an area.</summary>
    private void ReadStrips(PlyType type, long count)
    {
        var (a, b) = (0, 0);
        var corners = 0;
        for (; count > 0; count--)
        {
            var index = values.Next(type);
            if (index == -1)
            {
                corners = 0;
                continue;
            }
            var c = ToCorner(index);
            var isTriangle = corners >= 2 && a != b && b != c && c != a;
            if (isTriangle && corners % 2 == 0) mesh.AddTriangle(a, b, c);
            else if (isTriangle) mesh.AddTriangle(b, a, c);
            (a, b) = (b, c);
            corners++;
        }
    }

    private int ToCorner(double index)
    {
        if (index < 0 || index != Math.Floor(index)) throw values.Error($"a face index must be a whole number from 0 on, but is {index}");
        if (index >= header.VertexCount)
            throw values.Error($"face index {index} is beyond the file's {header.VertexCount} vertices, which count from 0");
        return (int)index;
    }

    private long ReadCount(PlyType type)
    {
        var count = values.Next(type);
        if (count < 0 || count != Math.Floor(count)) throw values.Error($"the count of a list must be a whole number from 0 on, but is {count}");
        return (long)count;
    }
}
