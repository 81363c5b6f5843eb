using System.Buffers.Text;

namespace RayCaster;

/// <summary>Wavefront OBJ: the statements <c>v x y z</c> and <c>f i j k …</c>; all others are skipped.</summary>
internal static class ObjFile
{
    public static MeshData Read(MeshSource source)
    {
        var mesh = Read(source, long.MaxValue, out var greatestIndex);
        // A face may stand before its vertices, so only now is the range known. The second reading stops at the first index beyond it.
        if (greatestIndex > mesh.VertexCount) Read(source, mesh.VertexCount, out _);
        return mesh.ToMesh();
    }

    private static MeshBuilder Read(MeshSource source, long vertexCount, out long greatestIndex)
    {
        var mesh = new MeshBuilder(source);
        var scanner = TextScanner.OfFile(source, isObj: true);
        greatestIndex = 0;
        do
        {
            var statement = scanner.NextInLine();
            if (statement is [(byte)'v'])
            {
                var (x, y, z) = (scanner.NextNumber("the vertex's x"), scanner.NextNumber("the vertex's y"), scanner.NextNumber("the vertex's z"));
                mesh.AddVertex(new(x, y, z));
            }
            else if (statement is [(byte)'f'])
            {
                mesh.BeginFace();
                while (scanner.NextInLine() is { IsEmpty: false } corner)
                {
                    var index = ToIndex(corner, scanner);
                    if (index > vertexCount) throw scanner.Error($"face index {index} is beyond the file's {vertexCount} vertices");
                    greatestIndex = Math.Max(greatestIndex, index);
                    if (index < -mesh.VertexCount)
                        throw scanner.Error($"face index {index} counts back beyond the {mesh.VertexCount} vertices that are above it");
                    // One beyond every array is cut here, and refused when the vertices have been counted.
                    mesh.AddCorner(unchecked((int)(index > 0 ? index - 1 : mesh.VertexCount + index)));
                }
                if (mesh.CornerCount < 3) throw scanner.Error($"a face needs at least three corners, but this one has {mesh.CornerCount}");
            }
        }
        while (scanner.NextLine());
        return mesh;
    }

    /// <summary>The vertex of a corner, which is written <c>7</c>, <c>7/1</c>, <c>7/1/3</c> or <c>7//3</c>: vertex, texture, normal.</summary>
    private static long ToIndex(ReadOnlySpan<byte> corner, TextScanner scanner)
    {
        var isCorner = Utf8Parser.TryParse(corner, out long index, out var length);
        var rest = corner[length..];
        for (var part = 0; isCorner && part < 2 && rest is [(byte)'/', ..]; part++)
        {
            Utf8Parser.TryParse(rest[1..], out long _, out length); // of length 0 where nothing is written
            rest = rest[(1 + length)..];
        }
        if (!isCorner || !rest.IsEmpty) throw scanner.Error($"a face's corner must be like 7, 7/1, 7/1/3 or 7//3, but is {scanner.Quoted}");
        if (index == 0) throw scanner.Error("face index 0 is not allowed: vertices count from 1, or from -1 backwards");
        return index;
    }
}
