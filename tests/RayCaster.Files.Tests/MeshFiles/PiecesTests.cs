using System.Text;

namespace RayCaster.Files.Tests.MeshFiles;

/// <summary>The result and the error do not depend on the pieces in which a file is loaded.</summary>
public sealed class PiecesTests : IDisposable
{
    private const string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    private const string plyHeader = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
        + "element face 2\nproperty list uchar int vertex_indices\nend_header\n";
    private const string facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";

    private readonly string folder = Directory.CreateTempSubdirectory("raycaster-").FullName;

    public static TheoryData<string, string> Texts => new()
    {
        { "a.obj", vertices + "f 1 2 3 4\nf -1 -2 -3 -4\nv 5 5 5\nf -1 1 -2\nf 6 7 5\nv 6 6 6\nv 7 7 7" },
        { "a.obj", vertices.Replace("\n", "\r\n") + "f 1 \\\r\n 2 \\\r\n3\r\n# f 1 1 1 \\\r\nf 1 3 4\r\n\\\r\nf 1 1 1\r\n" },
        { "a.obj", vertices.Replace("\n", "\r") + "f 1 \\\r 2 \\\r3\ro a\\b \\\rf 1 1 1\rf -1 -2 -3\r\r" },
        { "a.obj", "\uFEFFf 1 2 3\n" + vertices + "f -4 \\\n-3 \\\n\\\n-2 # \\\nf 4 3 2" },
        { "a.ply", plyHeader + "0 0 0\n1 0 0\n\n   \n1 1 0\n0 1 0\n4 0 1 2 3\n\t\n3 2 1 0" },
        { "a.ply", (plyHeader + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n\n4 0 1 2 3\n3 2 1 0\n\n").Replace("\n", "\r\n") },
        { "a.ply", (plyHeader + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n\n4 0 1 2 3\n3 2 1 0\n\n").Replace('\n', '\r') },
        { "a.stl", $"solid a endfacet\n{facet}{facet}endsolid a endfacet\n\n\nsolid facet\nendsolid\nsolid b\n{facet}endsolid" },
        { "a.stl", $"solid a\n{facet}{facet.Replace("endloop", "vertex 1 1 1\nendloop")}{facet}endsolid a\n".Replace("\n", " \r\n\t") },
        { "a.stl", $"solid a\n{facet}{facet}endsolid a\n".ToUpperInvariant().Replace('\n', '\r') },
        { "a.stl", $"solid a\n{facet}{facet}endsolid a\n".Replace('\n', ' ') },
        // three words, whatever they are
        { "a.stl", $"solid a\n{facet}{facet.Replace("0 0 1\nouter", "0\nendloop\nendfacet\nouter")}{facet}endsolid a\n" },
    };

    public static TheoryData<string, string> Mistakes => new()
    {
        { "a.obj", vertices + "f 1 2 3\nf 1 2 9\nf 1 2 8\n" },
        { "a.obj", vertices + "f 1 2 9\nf 1 2\nv 1 2\n" }, // what can be said before the vertices are counted comes first
        { "a.obj", vertices + "f 1 2 3\nf -1 -2 -5\nv 0 0 0\nf -1 -2 -6\n" },
        { "a.obj", "f -1 -1 -1\n" + vertices },
        { "a.obj", vertices + "f 1 2 -9223372036854775808\nf 1\n" },
        { "a.obj", vertices + "f 1 2 -1073741900\n" },
        { "a.obj", vertices + "f 1 2 3\nv 1 \\\n2 \\\nx\nv 1 2 y\n" },
        { "a.obj", (vertices + "f 1 2 3\nv 1 \\\n2 \\\n\n").Replace("\n", "\r\n") },
        { "a.obj", (vertices + "f 1 2 3\nv 1 \\\n2 \\\n").Replace("\n", "\r") },
        { "a.obj", vertices },
        { "a.obj", "" },
        { "a.ply", plyHeader + "0 0 0\n1 0 0\n1 x 0\n0 y 0\n3 0 1 2\n3 0 1 2\n" },
        { "a.ply", plyHeader + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 4\n2 0 1\n" },
        { "a.ply", plyHeader + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n\n         \n" },
        { "a.ply", plyHeader + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2          " },
        { "a.ply", plyHeader.Replace("face 2", "face 99") + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n" },
        { "a.ply", plyHeader.Replace("face 2", "face 99") + "0 0 0\n1 0 0 0\n1 1 0\n0 1 0\n3 0 1 2\n" },
        { "a.stl", $"solid a\n{facet}{facet}{facet}" },
        { "a.stl", $"solid a\n{facet}{facet}\n\nfacets\n{facet}endsolid" },
        { "a.stl", $"solid a\n{facet}{facet.Replace("vertex 1 0 0\n", "")}{facet.Replace("1 0 0", "x")}endsolid" },
        { "a.stl", $"solid a\n{facet}endsolid\n{facet}{facet}endsolid" },
        { "a.stl", $"{facet}{facet}endsolid" },
    };

    [Theory]
    [MemberData(nameof(Texts))]
    public void TextIsReadAlikeWhereverItIsCut(string path, string text) => AssertAlike(path, Encoding.UTF8.GetBytes(text), isSound: true);

    [Theory]
    [MemberData(nameof(Mistakes))]
    public void FirstMistakeIsRefusedAlikeWhereverTheTextIsCut(string path, string text) =>
        AssertAlike(path, Encoding.UTF8.GetBytes(text), isSound: false);

    [Fact]
    public void BinaryFileIsReadAlikeWhereverItIsCut()
    {
        var cube = MeshGenerator.Cube(1);
        AssertAlike("a.stl", MeshWriter.StlBinary(cube), isSound: true);
        AssertAlike("a.ply", MeshWriter.PlyBinary(cube, bigEndian: false), isSound: true);
        AssertAlike("a.ply", MeshWriter.PlyBinary(cube, bigEndian: true), isSound: true);
    }

    [Theory]
    [InlineData("little")]
    [InlineData("big")]
    public void ListsOfAnyLengthAreReadAlikeWhereverTheyAreCut(string endian)
    {
        var header = $"ply\nformat binary_{endian}_endian 1.0\nelement vertex 4\nproperty list char uchar before\n"
            + "property uchar x\nproperty char y\nproperty uchar z\nelement other 2\nproperty list uchar short values\n"
            + "element face 3\nproperty list uchar uchar vertex_indices\nproperty list uchar double after\nend_header\n";
        byte[] vertexRows = [0, 1, 2, 3, 2, 9, 9, 4, 5, 6, 1, 255, 7, 8, 9, 0, 10, 11, 12];
        byte[] faceRows = [5, 0, 1, 2, 3, 0, 0, 3, 1, 2, 3, 1, .. new byte[8], 4, 3, 2, 1, 0, 0];
        byte[] bytes = [.. Encoding.ASCII.GetBytes(header), .. vertexRows, 1, 1, 1, 0, .. faceRows];
        AssertAlike("a.ply", bytes, isSound: true);
        var faceAt = vertexRows.Length + 4;
        foreach (var (at, value) in new[] { (0, 255), (faceAt - 4, 255), (faceAt, 2), (faceAt + 1, 4), (faceAt + faceRows.Length - 6, 200) })
        {
            var broken = bytes.ToArray();
            broken[header.Length + at] = (byte)value;
            AssertAlike("a.ply", broken, isSound: false);
        }
    }

    [Fact]
    public void MistakesInBinaryDataAreRefusedAlikeWhereverItIsCut()
    {
        var cube = MeshGenerator.Cube(1);
        foreach (var (path, bytes) in new[] { ("a.stl", MeshWriter.StlBinary(cube)), ("a.ply", MeshWriter.PlyBinary(cube, bigEndian: false)) })
            for (var at = bytes.Length - 300; at < bytes.Length - 4; at += 7)
            {
                var broken = bytes.ToArray();
                broken.AsSpan(at, 4).Fill(0xFF); // no number, or an index below 0, or a count of 255
                AssertAlike(path, broken, isSound: null);
            }
    }

    /// <summary>Here several pieces of the usual size are read from a real file.</summary>
    [Theory]
    [InlineData("knot.obj")]
    [InlineData("knot.ply")]
    [InlineData("knot.stl")]
    public void LargeFileIsReadLikeItsBytesAtOnce(string name)
    {
        var knot = MeshGenerator.TorusKnot(2, 3, 1.9, 0.75, 0.4, rings: 400, sides: 100);
        var bytes = name switch
        {
            "knot.obj" => MeshWriter.Obj(knot),
            "knot.ply" => MeshWriter.PlyBinary(knot, bigEndian: true),
            _ => MeshWriter.StlBinary(knot),
        };
        Assert.InRange(bytes.Length, (1 << 20) + 1, int.MaxValue);
        var path = Path.Combine(folder, name);
        File.WriteAllBytes(path, bytes);
        FormatsTests.AssertSame(MeshBytes.Read(name, bytes, bytes.Length), MeshFile.Read(path));
    }

    [Fact]
    public void FileThatBecomesShorterWhileItIsReadIsRefused()
    {
        var stream = new MemoryStream();
        stream.Write(Encoding.ASCII.GetBytes(vertices + "f 1 2 3\n"));
        var source = new MeshSource("a.obj", stream, pieceSize: 8);
        stream.SetLength(20);
        Assert.Equal("a.obj: the file became shorter while it was read", Assert.Throws<ProblemException>(() => ObjFile.Read(source)).Message);
    }

    public void Dispose() => Directory.Delete(folder, recursive: true);

    /// <summary>Compares every size of pieces with the whole file as one.</summary>
    private static void AssertAlike(string path, byte[] bytes, bool? isSound)
    {
        var expected = Outcome(path, bytes, bytes.Length + 1);
        if (isSound is { } sound) Assert.Equal(sound, expected.Message is null);
        for (var pieceSize = 1; pieceSize <= bytes.Length; pieceSize += 1 + pieceSize / 64)
        {
            var actual = Outcome(path, bytes, pieceSize);
            Assert.Equal((pieceSize, expected.Message), (pieceSize, actual.Message));
            if (expected.Mesh is { } mesh) FormatsTests.AssertSame(mesh, actual.Mesh!);
        }
    }

    private static (MeshData? Mesh, string? Message) Outcome(string path, byte[] bytes, int pieceSize)
    {
        try
        {
            return (MeshBytes.Read(path, bytes, pieceSize), null);
        }
        catch (ProblemException e)
        {
            return (null, e.Message);
        }
    }
}
