using System.Text;

namespace RayCaster.Files.Tests.Meshes;

/// <summary>A mesh that is written in any format is read back unchanged.</summary>
public class FormatsTests
{
    private static readonly MeshData knot = MeshGenerator.TorusKnot(2, 3, 1.9, 0.75, 0.4, rings: 20, sides: 5);

    [Fact]
    public void ObjGivesTheMeshBack() => AssertSame(knot, MeshBytes.Read("knot.obj", MeshWriter.Obj(knot)));

    [Fact]
    public void AsciiPlyGivesTheMeshBack() => AssertSame(knot, MeshBytes.Read("knot.ply", MeshWriter.PlyAscii(knot)));

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void BinaryPlyGivesTheMeshBack(bool bigEndian) =>
        AssertSame(knot, MeshBytes.Read("knot.ply", MeshWriter.PlyBinary(knot, bigEndian)));

    [Fact]
    public void FloatPlyGivesTheMeshBackInFloats() => AssertSame(InFloats(knot), MeshBytes.Read("knot.ply", MeshWriter.PlyFloat(knot)));

    [Fact]
    public void AsciiStlGivesTheTrianglesBack() => AssertSame(Apart(knot), MeshBytes.Read("knot.stl", MeshWriter.StlAscii(knot)));

    [Theory]
    [InlineData("")]
    [InlineData("solid knot")] // many programs write this in front of binary data
    public void BinaryStlGivesTheTrianglesBackInFloats(string header) =>
        AssertSame(Apart(InFloats(knot)), MeshBytes.Read("knot.stl", MeshWriter.StlBinary(knot, header)));

    [Theory]
    [InlineData("mesh.OBJ")]
    [InlineData("mesh.Obj")]
    [InlineData("a.folder.stl/mesh.obj")]
    public void ExtensionMayBeInAnyCase(string path) => AssertSame(knot, MeshBytes.Read(path, MeshWriter.Obj(knot)));

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
