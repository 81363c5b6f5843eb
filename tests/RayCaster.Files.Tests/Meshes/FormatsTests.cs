using System.Text;

namespace RayCaster.Files.Tests.Meshes;

/// <summary>A mesh that is written in any format is read back unchanged.</summary>
public class FormatsTests
{
    private static readonly MeshData knot = MeshGenerator.TorusKnot(2, 3, 1.9, 0.75, 0.4, rings: 20, sides: 5);

    private static readonly Dictionary<string, (string Path, byte[] Bytes, MeshData Expected)> written = new()
    {
        ["OBJ"] = ("knot.obj", MeshWriter.Obj(knot), knot),
        ["OBJ, its extension in capitals"] = ("knot.OBJ", MeshWriter.Obj(knot), knot),
        ["OBJ in a folder with an extension"] = ("a.folder.stl/mesh.obj", MeshWriter.Obj(knot), knot),
        ["ascii PLY"] = ("knot.ply", MeshWriter.PlyAscii(knot), knot),
        ["little-endian PLY"] = ("knot.ply", MeshWriter.PlyBinary(knot, bigEndian: false), knot),
        ["big-endian PLY"] = ("knot.ply", MeshWriter.PlyBinary(knot, bigEndian: true), knot),
        ["PLY of floats"] = ("knot.ply", MeshWriter.PlyFloat(knot), InFloats(knot)),
        ["ascii STL"] = ("knot.stl", MeshWriter.StlAscii(knot), Apart(knot)),
        ["binary STL"] = ("knot.stl", MeshWriter.StlBinary(knot, ""), Apart(InFloats(knot))),
        ["binary STL that begins like a text"] = ("knot.stl", MeshWriter.StlBinary(knot, "solid knot"), Apart(InFloats(knot))),
    };

    public static TheoryData<string> Formats => [.. written.Keys];

    [Theory]
    [MemberData(nameof(Formats))]
    public void AMeshIsReadBackUnchanged(string format) =>
        AssertSame(written[format].Expected, MeshBytes.Read(written[format].Path, written[format].Bytes));

    [Theory]
    [InlineData("mesh.obj")]
    [InlineData("mesh.ply")]
    [InlineData("mesh.stl")]
    public void LinesMayEndWithCrLfOrCrAndBeginWithAByteOrderMark(string path)
    {
        var lines = path switch
        {
            "mesh.obj" => MeshWriter.Obj(knot),
            "mesh.ply" => MeshWriter.PlyAscii(knot),
            _ => MeshWriter.StlAscii(knot),
        };
        var text = Encoding.ASCII.GetString(lines);
        var expected = MeshBytes.Read(path, lines);
        AssertSame(expected, PiecesTests.ReadInPieces(path, Encoding.UTF8.GetBytes("\uFEFF" + text.Replace("\n", "\r\n"))));
        AssertSame(expected, PiecesTests.ReadInPieces(path, Encoding.UTF8.GetBytes(text.Replace('\n', '\r'))));
    }

    public static TheoryData<string> BrokenMeshes => BrokenTexts.Rows("Meshes.txt");

    [Theory]
    [MemberData(nameof(BrokenMeshes))]
    public void ABrokenMeshIsRefusedWithItsLine(string row)
    {
        var columns = BrokenTexts.Columns("Meshes.txt", row);
        Assert.Equal($"box.{columns[0]}{columns[2]}",
            Assert.Throws<ProblemException>(() => PiecesTests.ReadInPieces($"box.{columns[0]}", Encoding.UTF8.GetBytes(columns[1]))).Message);
    }

    /// <summary>A download may stop at any byte: what is left is refused, or is read where only the end of a number or of the last line is
    /// missing.</summary>
    [Theory(Explicit = true)]
    [MemberData(nameof(Formats))]
    public void EveryPrefixOfAFileIsReadOrRefused(string format)
    {
        var (path, bytes, _) = written[format];
        for (var length = 0; length < bytes.Length; length++)
        {
            var refused = Record.Exception(() => MeshBytes.Read(path, bytes[..length])); // any other exception fails here
            Assert.True(refused is null or ProblemException, $"{path} cut at {length}: {refused}");
            // Only a cut text can still be right: OBJ has no end mark, and the other two can lose their last line end.
            if (!format.StartsWith("OBJ") && length < bytes.Length - 1 && refused is null)
                Assert.EndsWith("endsolid mesh\n", Encoding.ASCII.GetString(bytes));
        }
    }

    internal static void AssertSame(MeshData expected, MeshData actual)
    {
        Assert.Equal(expected.Vertices, actual.Vertices);
        Assert.Equal(expected.Indices, actual.Indices);
    }

    private static MeshData InFloats(MeshData mesh) =>
        mesh with { Vertices = [.. mesh.Vertices.Select(v => new Vector3((float)v.X, (float)v.Y, (float)v.Z))] };

    /// <summary>The same triangles, each with vertices of its own, as STL has them.</summary>
    private static MeshData Apart(MeshData mesh) =>
        new([.. mesh.Indices.Select(index => mesh.Vertices[index])], [.. Enumerable.Range(0, mesh.Indices.Length)]);
}
