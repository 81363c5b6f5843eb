namespace RayCaster.Files;

/// <summary>STL, binary or ascii. Each triangle has its own three vertices; the normals are not needed.</summary>
internal static class StlFile
{
    /// <summary>The bytes of a binary file before its first triangle; the last four are the count of triangles.</summary>
    private const int Header = 84;

    private const string Kind = "an STL mesh";

    /// <summary>A normal, three vertices and two more bytes.</summary>
    private const int BytesPerTriangle = 50;

    /// <summary>The size decides: a binary file may begin with "solid" too.</summary>
    public static MeshData Read(MeshSource source)
    {
        if (!source.Has(Header))
        {
            source.ThrowUnless(Kind);
            return AsciiStlFile.Read(source);
        }
        var header = source.Bytes[..Header];
        var count = BinaryPrimitives.ReadUInt32LittleEndian(header[^4..]);
        var rest = source.Length - Header - BytesPerTriangle * (long)count;
        if (rest == 0) return ReadBinary(source, count);
        source.ThrowUnless(Kind);
        // A text has no zero bytes, so this is a binary file that was cut; the ascii reader's message would mislead.
        var isBinary = header.Contains((byte)0);
        var hasMore = rest is > 0 and < BytesPerTriangle;
        if (isBinary && !hasMore)
            throw source.ErrorAtByte(Header - 4,
                $"the header promises {count} triangles, which take {source.Length - rest} bytes, but the file has {source.Length}");
        try
        {
            if (!isBinary) return AsciiStlFile.Read(source);
        }
        catch (ProblemException) when (hasMore)
        {
            source.Restart();
            source.Has(Header);
        }
        return ReadBinary(source, count, $"the file has {Digits.Count(rest, "byte")} after its last triangle; they are ignored");
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static MeshData ReadBinary(MeshSource source, uint count, string? warning = null)
    {
        var mesh = new MeshBuilder(source);
        source.Skip(Header);
        for (; count > 0; count--)
        {
            var offset = source.Position;
            var vertex = mesh.VertexCount;
            var triangle = source.Take(BytesPerTriangle);
            for (var at = 12; at < 48; at += 12)
                mesh.AddVertex(new(Float(triangle, at), Float(triangle, at + 4), Float(triangle, at + 8)));
            mesh.AddTriangle(vertex, vertex + 1, vertex + 2);

            double Float(ReadOnlySpan<byte> bytes, int at)
            {
                var value = BinaryPrimitives.ReadSingleLittleEndian(bytes[at..]);
                return float.IsFinite(value)
                    ? value
                    : throw source.ErrorAtByte(offset + at, $"a coordinate must be a finite number, but is {value}");
            }
        }
        return mesh.Finish(warning);
    }
}
