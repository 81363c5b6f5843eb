using System.Text;

namespace RayCaster.Files.Tests.Meshes;

/// <summary>The result and the error do not depend on the pieces in which a file is loaded. The tests of each format read their files in pieces,
/// too.</summary>
public sealed class PiecesTests : InTemporaryFolder
{
    [Fact]
    public void BinaryFileIsReadAlikeWhereverItIsCut()
    {
        var cube = MeshGenerator.Cube(1);
        ReadInPieces("a.stl", MeshWriter.StlBinary(cube));
        ReadInPieces("a.ply", MeshWriter.PlyBinary(cube, bigEndian: false));
        ReadInPieces("a.ply", MeshWriter.PlyBinary(cube, bigEndian: true));
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
        ReadInPieces("a.ply", bytes);
        var faceAt = vertexRows.Length + 4;
        foreach (var (at, value) in new[] { (0, 255), (faceAt - 4, 255), (faceAt, 2), (faceAt + 1, 4), (faceAt + faceRows.Length - 6, 200) })
        {
            var broken = bytes.ToArray();
            broken[header.Length + at] = (byte)value;
            Assert.Throws<ProblemException>(() => ReadInPieces("a.ply", broken));
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
                Assert.True(Record.Exception(() => ReadInPieces(path, broken)) is null or ProblemException);
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
        FormatsTests.AssertSame(MeshBytes.Read(name, bytes, bytes.Length), MeshFile.Read(folder.Write(name, bytes)));
    }

    [Fact]
    public void FileThatBecomesShorterWhileItIsReadIsRefused()
    {
        var stream = new MemoryStream();
        stream.Write(Encoding.ASCII.GetBytes("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n"));
        var source = new MeshSource("a.obj", stream, pieceSize: 8);
        stream.SetLength(20);
        Assert.Equal("a.obj: the file became shorter while it was read", Assert.Throws<ProblemException>(() => ObjFile.Read(source)).Message);
    }

    /// <summary>Reads a file in pieces of some sizes, which must give what the whole gives at once: the mesh, or the refusal.</summary>
    internal static MeshData ReadInPieces(string path, byte[] bytes)
    {
        var expected = Outcome(path, bytes, bytes.Length + 1);
        foreach (var pieceSize in new[] { 1, 2, 3, 7, bytes.Length / 2, bytes.Length - 1 }.Where(size => size > 0))
        {
            var actual = Outcome(path, bytes, pieceSize);
            Assert.Equal((pieceSize, expected.Message), (pieceSize, actual.Message));
            if (expected.Mesh is { } mesh) FormatsTests.AssertSame(mesh, actual.Mesh!);
        }
        return expected.Mesh ?? throw new ProblemException(expected.Message!);
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
