using System.Buffers.Text;

namespace RayCaster.Files;

/// <summary>Wavefront OBJ: the statements <c>v x y z</c> and <c>f i j k …</c>; all others are skipped.</summary>
internal sealed class ObjFile : MeshFormat
{
    private readonly long vertexCount;

    private ObjFile(MeshSource source, long vertexCount = long.MaxValue) : base(source) => this.vertexCount = vertexCount;

    public static MeshData Read(MeshSource source)
    {
        var mesh = MeshReader.Read(source, () => new ObjFile(source));
        // A face may stand before its vertices, so the range of indices is known only now. A second reading stops at the first index beyond it.
        if (!mesh.Indices.AsSpan().ContainsAnyInRange(mesh.Vertices.Length, int.MaxValue)) return mesh;
        MeshReader.ReadInOrder(source, new ObjFile(source, mesh.Vertices.Length));
        throw source.Error("the file changed while it was read");
    }

    public override void Read(MeshBlock block, MeshBuilder mesh)
    {
        var scanner = new TextScanner(block, isObj: true);
        do
        {
            var statement = scanner.NextInLine();
            if (statement is [(byte)'v'])
            {
                mesh.AddVertex(new(
                    scanner.NextNumber("the vertex's x"), scanner.NextNumber("the vertex's y"), scanner.NextNumber("the vertex's z")));
                while (scanner.NextInLine() is { IsEmpty: false } more) scanner.ToNumber(more, "what follows a vertex's x, y and z");
            }
            else if (statement is [(byte)'f'])
            {
                mesh.BeginFace();
                while (scanner.NextInLine() is { IsEmpty: false } corner)
                {
                    var index = ToIndex(corner, scanner);
                    if (index > vertexCount) throw scanner.Error($"face index {index} is beyond the file's {vertexCount} vertices");
                    if (index < -mesh.VerticesAbove)
                        throw scanner.Error($"face index {index} counts back beyond the {mesh.VerticesAbove} vertices that are above it");
                    if (index > 0) mesh.AddCorner(index - 1);
                    else mesh.AddCornerBack(index);
                }
                if (mesh.CornerCount < 3) throw scanner.Error($"a face needs at least three corners, but this one has {mesh.CornerCount}");
            }
        }
        while (scanner.NextLine());
    }

    /// <summary>After any line that no backslash continues.</summary>
    public override int Cut(ReadOnlySpan<byte> text, bool isEnd)
    {
        if (isEnd) return text.Length;
        for (var left = text; TextScanner.TryTakeLastLine(ref left, out var line);)
        {
            var isCrLf = line.IsEmpty && left is [.., (byte)'\r'];
            if ((isCrLf ? left[..^1] : line) is not [.., (byte)'\\']) return left.Length + 1;
        }
        return 0;
    }

    /// <summary>The vertex of a corner: <c>7</c>, <c>7/1</c>, <c>7/1/3</c> or <c>7//3</c> (vertex, texture, normal).</summary>
    private static long ToIndex(ReadOnlySpan<byte> corner, TextScanner scanner)
    {
        var isCorner = Utf8Parser.TryParse(corner, out long index, out var length);
        var rest = corner[length..];
        for (var part = 0; isCorner && part < 2 && rest is [(byte)'/', ..]; part++)
        {
            Utf8Parser.TryParse(rest[1..], out long _, out length); // of length 0 where nothing is written
            rest = rest[(1 + length)..];
        }
        if (!isCorner || !rest.IsEmpty || corner is [.., (byte)'/'])
            throw scanner.Error($"a face's corner must be like 7, 7/1, 7/1/3 or 7//3, but is {scanner.Quoted}");
        if (index == 0) throw scanner.Error("face index 0 is not allowed: vertices count from 1, or from -1 backwards");
        return index;
    }
}
