using System.Buffers.Binary;
using System.Text;

namespace RayCaster.Files.Tests.Meshes;

public class StlFileTests
{
    private const string facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";

    [Theory]
    [InlineData("solid\n" + facet + "endsolid")]
    [InlineData("solid a name of words\n" + facet + "endsolid a name of words\n")]
    [InlineData("solid Facet 1\n" + facet + "endsolid Solid 1\n")] // keywords are no keywords in a name
    [InlineData("solid\n facet normal nan -nan(ind) 1.#QNAN\nouter loop vertex 0 0 0 vertex 1 0 0 vertex\n0\n1\n0 endloop endfacet endsolid")]
    public void TriangleIsReadHoweverItIsWritten(string text) =>
        Assert.Equal([new(0, 0, 0), new(1, 0, 0), new(0, 1, 0)], Read(text).Vertices);

    [Theory]
    [InlineData("end loop", "endfacet", "endsolid a")]
    [InlineData("endloop", "end facet", "end solid a\n")]
    [InlineData("END LOOP", "End Facet", "end solid\n\n")]
    public void EndMayBeAWordOfItsOwn(string endLoop, string endFacet, string endSolid)
    {
        var mesh = Read("solid a\n" + (facet + facet).Replace("endloop", endLoop).Replace("endfacet", endFacet) + endSolid);
        Assert.Equal((6, null), (mesh.Vertices.Length, mesh.Warning));
    }

    [Theory]
    [InlineData(false, true)]
    [InlineData(true, true)]
    [InlineData(false, false)]
    public void Utf16IsNamed(bool bigEndian, bool hasMark)
    {
        var encoding = new UnicodeEncoding(bigEndian, hasMark);
        foreach (var text in (string[])["solid a\nendsolid", "solid a\n" + facet + "endsolid a\n"])
            Assert.Equal("box.stl(1): the file is in UTF-16; save it as UTF-8", Assert.Throws<ProblemException>(
                () => MeshBytes.Read("box.stl", [.. encoding.GetPreamble(), .. encoding.GetBytes(text)])).Message);
    }

    [Fact]
    public void KeywordsMayBeInAnyCaseAndAllOnOneLine() =>
        Assert.Equal([0, 1, 2, 3, 4, 5], Read(("solid box " + facet + facet + "endsolid box").Replace('\n', '\t').ToUpperInvariant()).Indices);

    [Fact]
    public void FileMayHoldSeveralSolids() =>
        Assert.Equal(9, Read($"solid a\n{facet}endsolid a\n\nsolid b\nendsolid b\nsolid\n{facet}{facet}endsolid").Vertices.Length);

    [Fact]
    public void FacetOfMoreThanThreeVerticesBecomesAFan() =>
        Assert.Equal([0, 1, 2, 0, 2, 3], Read("solid\n" + facet.Replace("endloop", "vertex 1 1 1\nendloop") + "endsolid\n").Indices);

    [Fact]
    public void BinaryFileWhoseSizeIsNotWhatItsHeaderPromisesIsRefused()
    {
        var bytes = MeshWriter.StlBinary(MeshGenerator.Cube(1), "solid cube");
        Assert.Equal("cube.stl(byte 80): the header promises 12 triangles, which take 684 bytes, but the file has 683",
            Assert.Throws<ProblemException>(() => MeshBytes.Read("cube.stl", bytes[..^1])).Message);
        BinaryPrimitives.WriteUInt32LittleEndian(bytes.AsSpan(80), uint.MaxValue);
        Assert.Equal("cube.stl(byte 80): the header promises 4294967295 triangles, which take 214748364834 bytes, but the file has 684",
            Assert.Throws<ProblemException>(() => MeshBytes.Read("cube.stl", bytes)).Message);
    }

    [Theory]
    [InlineData(1, "solid cube", "1 byte after its last triangle; they are ignored")]
    [InlineData(49, "", "49 bytes after its last triangle; they are ignored")]
    public void BytesAfterTheLastTriangleAreWarnedOf(int more, string start, string warning)
    {
        var cube = MeshWriter.StlBinary(MeshGenerator.Cube(1), start);
        var mesh = MeshBytes.Read("cube.stl", [.. cube, .. new byte[more]]);
        FormatsTests.AssertSame(MeshBytes.Read("cube.stl", cube), mesh);
        Assert.Equal("the file has " + warning, mesh.Warning);
        cube.AsSpan(10, 70).Fill((byte)' '); // without a zero in its header it may be a text
        cube[80] = 12;
        Assert.Equal("the file has " + warning, MeshBytes.Read("cube.stl", [.. cube, .. new byte[more]]).Warning);
    }

    [Fact]
    public void TextAfterALoopOrFacetIsWarnedOf()
    {
        var text = "solid\n" + facet + facet.Replace("endloop", "endloop a b").Replace("endfacet", "endfacet 12") + facet + "endsolid\n";
        var mesh = Read(text);
        Assert.Equal(9, mesh.Vertices.Length);
        Assert.Equal("text after endloop or endfacet is ignored, first in line 14 of the file", mesh.Warning);
        Assert.Equal("box.stl(8): expected 'endfacet', found 'a'",
            Assert.Throws<ProblemException>(() => Read("solid\n" + facet.Replace("endloop", "endloop\na"))).Message);
    }

    [Fact]
    public void BinaryFileOfNoTriangleIsRefused() => Assert.Equal("cube.stl: the file has no face; a mesh needs at least one",
        Assert.Throws<ProblemException>(() => MeshBytes.Read("cube.stl", new byte[84])).Message);

    [Theory]
    [InlineData(96, float.NaN, "NaN")]
    [InlineData(128, float.NegativeInfinity, "-Infinity")]
    [InlineData(146, float.PositiveInfinity, "Infinity")] // the second triangle begins at 134 with its normal
    public void CoordinateThatIsNotFiniteIsNamedWithItsByte(int at, float value, string text)
    {
        var bytes = MeshWriter.StlBinary(MeshGenerator.Cube(1));
        BinaryPrimitives.WriteSingleLittleEndian(bytes.AsSpan(at), value);
        Assert.Equal($"cube.stl(byte {at}): a coordinate must be a finite number, but is {text}",
            Assert.Throws<ProblemException>(() => MeshBytes.Read("cube.stl", bytes)).Message);
    }

    [Fact]
    public void NormalsAreNotRead()
    {
        var bytes = MeshWriter.StlBinary(MeshGenerator.Cube(1));
        var mesh = MeshBytes.Read("cube.stl", bytes);
        BinaryPrimitives.WriteSingleLittleEndian(bytes.AsSpan(84), float.NaN);
        FormatsTests.AssertSame(mesh, MeshBytes.Read("cube.stl", bytes));
    }

    private static MeshData Read(string text) => PiecesTests.ReadInPieces("box.stl", Encoding.ASCII.GetBytes(text));
}
