using System.Buffers.Binary;
using System.Text;

namespace RayCaster;

/// <summary>STL, binary or ascii. Each triangle brings its own three vertices; the normals are not needed.</summary>
internal static class StlFile
{
    private const int header = 84, bytesPerTriangle = 50;

    /// <summary>The size decides: a binary file may begin with "solid" too.</summary>
    public static MeshData Read(MeshSource source)
    {
        var bytes = source.Bytes;
        if (bytes.Length < header) return ReadAscii(source);
        var count = BinaryPrimitives.ReadUInt32LittleEndian(bytes.AsSpan(header - 4));
        var size = header + bytesPerTriangle * (long)count;
        if (size == bytes.Length) return ReadBinary(source, (int)count);
        // No text has zero bytes in it, so this is a binary file that was cut, and the ascii reader's message would mislead.
        if (bytes.AsSpan(0, header).Contains((byte)0))
            throw source.ErrorAtByte(header - 4, $"the header promises {count} triangles, which take {size} bytes, but the file has {bytes.Length}");
        return ReadAscii(source);
    }

    private static MeshData ReadBinary(MeshSource source, int count)
    {
        var mesh = new MeshBuilder(source);
        mesh.ReserveVertices(3 * count);
        mesh.ReserveTriangles(count);
        for (var i = 0; i < count; i++)
        {
            var at = header + bytesPerTriangle * i + 12; // past the normal
            for (var corner = 0; corner < 3; corner++, at += 12) mesh.AddVertex(new(Float(at), Float(at + 4), Float(at + 8)));
            mesh.AddTriangle(3 * i, 3 * i + 1, 3 * i + 2);
        }
        return mesh.ToMesh();

        double Float(int at)
        {
            var value = BinaryPrimitives.ReadSingleLittleEndian(source.Bytes.AsSpan(at));
            return float.IsFinite(value) ? value : throw source.ErrorAtByte(at, $"a coordinate must be a finite number, but is {value}");
        }
    }

    private static MeshData ReadAscii(MeshSource source)
    {
        var mesh = new MeshBuilder(source);
        var scanner = TextScanner.OfFile(source);
        var word = scanner.Next();
        if (!Is(word, "solid")) throw scanner.Error($"an ascii STL file must begin with 'solid', but this one begins with {scanner.Quoted}");
        while (!word.IsEmpty)
        {
            if (!Is(word, "solid")) throw Expected("solid");
            for (word = NextAfterName(); Is(word, "facet"); word = scanner.Next()) ReadFacet();
            if (!Is(word, "endsolid")) throw Expected("facet' or 'endsolid");
            word = scanner.NextLine() ? scanner.Next() : []; // the name may stand here again
        }
        return mesh.ToMesh();

        void ReadFacet()
        {
            Expect("normal");
            for (var i = 0; i < 3; i++) scanner.Next(); // read by nobody: programs write nan into those of slivers
            Expect("outer");
            Expect("loop");
            mesh.BeginFace();
            var word = scanner.Next();
            for (; Is(word, "vertex"); word = scanner.Next())
            {
                var (x, y, z) = (Number("the vertex's x"), Number("the vertex's y"), Number("the vertex's z"));
                mesh.AddCorner(mesh.VertexCount);
                mesh.AddVertex(new(x, y, z));
            }
            if (!Is(word, "endloop")) throw Expected("vertex' or 'endloop");
            if (mesh.CornerCount < 3) throw scanner.Error($"a facet needs at least three vertices, but this one has {mesh.CornerCount}");
            Expect("endfacet");
        }

        // On a later line if need be, but where that has no number, it is this line that misses one.
        double Number(string what)
        {
            var word = scanner.NextInLine();
            if (!word.IsEmpty) return scanner.ToNumber(word, what);
            var lineEnd = scanner.WordAt;
            return DecimalNumber.TryParse(scanner.Next(), out var number) ? number : throw source.ErrorAtLine(lineEnd, $"{what} is missing");
        }

        // A solid's name is the rest of its line, unless somebody has written the whole solid as one line.
        ReadOnlySpan<byte> NextAfterName()
        {
            while (scanner.NextInLine() is { IsEmpty: false } word)
            {
                var afterWord = scanner.Position;
                if (Is(word, "facet") && Is(scanner.NextInLine(), "normal"))
                {
                    scanner.Position = afterWord;
                    return word;
                }
                scanner.Position = afterWord;
            }
            return scanner.Next();
        }

        void Expect(string keyword)
        {
            if (!Is(scanner.Next(), keyword)) throw Expected(keyword);
        }

        MeshFileException Expected(string keyword) => scanner.Error($"expected '{keyword}', found {scanner.Quoted}");
    }

    private static bool Is(ReadOnlySpan<byte> word, string keyword) => Ascii.EqualsIgnoreCase(word, keyword);
}
