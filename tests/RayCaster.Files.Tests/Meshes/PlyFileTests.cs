using System.Text;

namespace RayCaster.Files.Tests.Meshes;

public class PlyFileTests
{
    private const string vertex = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
    private const string face = "element face 1\nproperty list uchar int vertex_indices\n";
    private const string start = "ply\nformat ascii 1.0\n"; // two lines; vertex has four, face two, end_header one
    private const string corners = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n"; // lines 10 to 13

    [Theory]
    [InlineData("vertex_indices")]
    [InlineData("vertex_index")]
    public void PolygonBecomesAFanFromItsFirstVertex(string name) => Assert.Equal([3, 1, 2, 3, 2, 0],
        Read(start + vertex + face.Replace("vertex_indices", name) + "end_header\n" + corners + "4 3 1 2 0\n").Indices);

    /// <summary>The corners 0 1 2 3 are a strip, the second triangle turned; −1 begins another; 3 3 joins it with the next by triangles without an
    /// area.</summary>
    [Fact]
    public void StripsOfTrianglesAreReadLikeFaces()
    {
        const string strips = "element tristrips 1\nproperty list int int vertex_indices\nend_header\n";
        Assert.Equal([0, 1, 2, 2, 1, 3], Read(start + vertex + strips + corners + "4 0 1 2 3\n").Indices);
        Assert.Equal([0, 1, 2, 1, 2, 3], Read(start + vertex + strips + corners + "7 0 1 2 -1 1 2 3\n").Indices);
        Assert.Equal([0, 1, 2, 0, 3, 1], Read(start + vertex + strips + corners + "8 0 1 2 2 3 3 0 1\n").Indices);
        AssertRefused(start + vertex + strips + corners + "3 0 1 4\n", "(14): face index 4 is beyond the file's 4 vertices, which count from 0");
        AssertRefused(start + vertex + strips + corners + "3 0 1 -2\n", "(14): a face index must be a whole number from 0 on, but is -2");
        Assert.Equal(6, Read(start + vertex + face + strips + corners + "3 0 1 2\n3 1 2 3\n").Indices.Length);
    }

    [Fact]
    public void OtherElementsAndPropertiesAreSkipped()
    {
        var mesh = Read("ply\ncomment made by hand\nformat ascii 1.0\nobj_info none\n"
            + "element camera 1\nproperty float view_px\nproperty list uint8 float64 more\nelement nothing 4000000000\n"
            + "element vertex 3\nproperty list char short before\nproperty double z\nproperty uchar red\nproperty float y\nproperty float x\n" +
            "property float nx\n"
            + "element edge 2\nproperty int32 vertex1\nproperty int32 vertex2\n"
            + "element face 1\nproperty ushort flags\nproperty list uint uint vertex_indices\nproperty list uchar float texcoord\nend_header\n"
            + "1.5 2 nan nan\n"
            + "0 3 255 2 1 nan\n2 7 8 6 255 5 4 -inf\n\n 1 7\t9 255 8 7 0 \n"
            + "0 1\n1 2\n"
            + "7 3 2 1 0 6 .1 .2 .3 .4 .5 .6");
        Assert.Equal([new(1, 2, 3), new(4, 5, 6), new(7, 8, 9)], mesh.Vertices);
        Assert.Equal([2, 1, 0], mesh.Indices);
    }

    [Theory]
    [InlineData("char", "int8", 1)]
    [InlineData("uchar", "uint8", 1)]
    [InlineData("short", "int16", 2)]
    [InlineData("ushort", "uint16", 2)]
    [InlineData("int", "int32", 4)]
    [InlineData("uint", "uint32", 4)]
    [InlineData("float", "float32", 4)]
    [InlineData("double", "float64", 8)]
    public void EachTypeHasItsBytesUnderBothNames(string oldName, string newName, int size)
    {
        foreach (var type in new[] { oldName, newName })
            foreach (var bigEndian in new[] { false, true })
            {
                // The value 1 in this type, beside a list of three values that is skipped; then three corners 0.
                var one = type.StartsWith('f') ? BitConverter.GetBytes(1f) : type is "double" ? BitConverter.GetBytes(1d)
                    : [1, .. new byte[size - 1]];
                if (type == "float64") one = BitConverter.GetBytes(1d);
                if (bigEndian) Array.Reverse(one);
                var header =
                    $"ply\nformat binary_{(bigEndian ? "big" : "little")}_endian 1.0\nelement vertex 1\nproperty list uchar {type} skipped\n"
                    + $"property {type} x\nproperty {type} y\nproperty {type} z\nelement face 1\nproperty list uchar {type} " +
                    "vertex_index\nend_header\n";
                byte[] bytes = [.. Encoding.ASCII.GetBytes(header), 3, .. new byte[3 * size], .. one, .. one, .. one, 3, .. new byte[3 * size]];
                FormatsTests.AssertSame(new([new(1, 1, 1)], [0, 0, 0]), MeshBytes.Read("one.ply", bytes));
            }
    }

    [Fact]
    public void NegativeNumbersKeepTheirSignInBinary()
    {
        var header = "ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty char x\nproperty short y\nproperty int z\n"
            + "element face 1\nproperty list ushort uchar vertex_index\nend_header\n";
        var mesh = MeshBytes.Read("one.ply", [.. Encoding.ASCII.GetBytes(header), 0xFF, 0xFF, 0xFE, 0xFF, 0xFF, 0xFF, 0xFD, 0, 3, 0, 0, 0]);
        Assert.Equal(new(-1, -2, -3), mesh.Vertices[0]);
    }

    [Theory]
    [InlineData("\n")]
    [InlineData("\r\n")]
    [InlineData("\r")]
    public void BinaryDataMayBeginWithALineFeedWhateverEndsTheLinesOfTheHeader(string lineEnd)
    {
        var header = "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty uchar x\nproperty uchar y\nproperty uchar z\n"
            + "element face 1\nproperty list uchar uchar vertex_index\nend_header\n";
        byte[] bytes = [.. Encoding.ASCII.GetBytes(header.Replace("\n", lineEnd)), 10, 11, 12, 3, 0, 0, 0];
        Assert.Equal(new(10, 11, 12), MeshBytes.Read("one.ply", bytes).Vertices[0]);
    }

    [Theory]
    [InlineData("\n\n \r\n", null)]
    [InlineData("\u0003", "there is more in the file than the rows that its header promises")]
    public void OnlyBlanksMayFollowTheLastRow(string rest, string? refusal)
    {
        Assert.Equal(3, Read(start + vertex + face + "end_header\n" + corners + "3 0 1 2\n\n\n \r\n").Indices.Length);
        var cube = MeshWriter.PlyBinary(MeshGenerator.Cube(1), bigEndian: false);
        byte[] longer = [.. cube, .. Encoding.ASCII.GetBytes(rest)];
        if (refusal is null) Assert.Equal(36, MeshBytes.Read("cube.ply", longer).Indices.Length);
        else
            Assert.Equal($"cube.ply(byte {cube.Length}): {refusal}",
                Assert.Throws<ProblemException>(() => MeshBytes.Read("cube.ply", longer)).Message);
    }

    [Fact]
    public void ARowMayGoOnOnTheNextLines() => Assert.Equal([0, 1, 2, 0, 2, 3],
        Read(start + vertex + face + "end_header\n0 0\n 0\n1\n0\n0\n1 1 0\n0 1 0\n4 0 1\n2\n\n3\n").Indices);

    [Fact]
    public void AFaceOfAnotherShapeThanItsFanIsWarnedOf()
    {
        var text = start + vertex.Replace("4", "5") + face + "end_header\n0 0 0\n2 0 0\n2 2 0\n1 0.5 0\n0 2 0\n5 0 1 2 3 4\n";
        Assert.StartsWith("the face in line 15 is not convex", Read(text).Warning);
    }

    // Eight vertices of three doubles, then, from byte 192 of the data on, twelve faces: a byte and three ints.
    [Theory]
    [InlineData(0, 8, 0x7FF0_0000_0000_0000, "the value must be a finite number, but is Infinity")]
    [InlineData(184, 8, 0x7FF8_0000_0000_0000, "the value must be a finite number, but is NaN")]
    [InlineData(192, 1, 2, "a face needs at least three corners, but this one has 2")]
    [InlineData(193, 4, 8, "face index 8 is beyond the file's 8 vertices, which count from 0")]
    [InlineData(193, 4, -1, "a face index must be a whole number from 0 on, but is -1")]
    public void MistakeInBinaryDataIsNamedWithItsByte(int at, int size, long value, string reason)
    {
        var dataAt = MeshWriter.PlyBinary(MeshGenerator.Cube(1), bigEndian: false).Length - 348; // 348 bytes of data
        Assert.Equal($"cube.ply(byte {dataAt + at}): {reason}", RefuseCube(at, size, value).Message);
    }

    [Fact]
    public void ListBeyondTheEndOfTheFileIsRefusedThere() =>
        Assert.EndsWith(": the file ends before all that its header promises", RefuseCube(192 + 11 * 13, 1, 4).Message);

    private static ProblemException RefuseCube(int at, int size, long value)
    {
        var bytes = MeshWriter.PlyBinary(MeshGenerator.Cube(1), bigEndian: false);
        BitConverter.GetBytes(value).AsSpan(0, size).CopyTo(bytes.AsSpan(bytes.Length - 348 + at));
        return Assert.Throws<ProblemException>(() => MeshBytes.Read("cube.ply", bytes));
    }

    private static void AssertRefused(string text, string message) =>
        Assert.Equal("box.ply" + message, Assert.Throws<ProblemException>(() => Read(text)).Message);

    private static MeshData Read(string text) => PiecesTests.ReadInPieces("box.ply", Encoding.ASCII.GetBytes(text));
}
