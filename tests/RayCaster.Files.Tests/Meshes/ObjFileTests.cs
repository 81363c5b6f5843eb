using System.Text;

namespace RayCaster.Files.Tests.Meshes;

public class ObjFileTests
{
    private const string fourVertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

    [Theory]
    [InlineData("f 1 2 3\n")]
    [InlineData("f 1 2 3")] // the last line need not end
    [InlineData("f 1/1 2/2 3/3\n")]
    [InlineData("f 1/1/1 2/2/2 3/3/3\n")]
    [InlineData("f 1//1 2//2 3//3\n")]
    [InlineData("f 1/ 2// 3/1/\n")] // as some programs write them
    [InlineData("f 1/-1/-1 2 3//-7\n")]
    [InlineData("f -4 -3 -2\n")]
    [InlineData("f\t1  2\t3 \t\n")]
    [InlineData("  f 1 2 3\n")]
    [InlineData("f 1 2 3 # a comment\n")]
    [InlineData("f 1 2 3# a comment\\\n")] // which no backslash continues
    [InlineData("f 1 \\\n 2\\\r\n3\n")]
    [InlineData("f\\\n1 2\\\n3\n")]
    [InlineData("g C:\\parts\\\nf 1 2 3\n")] // a name may end so; only vertices and faces go on on the next line
    [InlineData("mtllib D:\\\r\nf 1 2 3\n")]
    [InlineData("\n\n# f 1 1 1\r\n\r\nf 1 2 3\n")]
    [InlineData("mtllib a.mtl\no box\ng all\nvt 0 0\nvn 0 0 1\nvp 1\nusemtl red\ns off\nl 1 2\nfo 1 1 1\nf 1 2 3\n")]
    public void FaceIsReadHoweverItIsWritten(string faces) => Assert.Equal([0, 1, 2], Read(fourVertices + faces).Indices);

    [Fact]
    public void PolygonBecomesAFanFromItsFirstVertex() =>
        Assert.Equal([3, 1, 2, 3, 2, 0, 3, 0, 4], Read(fourVertices + "v 5 5 5\nf 4 2 3 1 5\n").Indices);

    [Fact]
    public void MaterialsAreWarnedOfOnce()
    {
        Assert.Null(Read(fourVertices + "f 1 2 3\n").Warning);
        Assert.Equal("the file's materials are ignored; \"color\" colours the whole mesh",
            Read("mtllib a.mtl\n" + fourVertices + "usemtl red\nf 1 2 3\n").Warning);
        using var folder = new TemporaryFolder();
        folder.Write("a.obj", "usemtl red\n" + fourVertices + "f 1 2 3\n");
        var reading = SceneReader.Parse("""
            {
              "camera": { "position": [5, 0, 0], "target": [0, 0, 0] },
              "models": [ { "type": "mesh", "file": "a.obj" },
                          { "type": "mesh", "file": "a.obj" } ]
            }
            """u8.ToArray(), "scene.json", folder.Path);
        Assert.StartsWith("scene.json(3,41): warning: models[0].file: the file's materials are ignored", Assert.Single(reading.Problems).ToString());
        Assert.NotNull(reading.Scene);
    }

    [Fact]
    public void NegativeIndexCountsBackFromTheVerticesAboveIt() =>
        Assert.Equal([0, 1, 2, 1, 2, 3], Read("v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 0 1 0\nf -3 -2 -1\n").Indices);

    [Fact]
    public void FaceMayStandAboveItsVertices() => Assert.Equal([0, 1, 3], Read("f 1 2 4\n" + fourVertices).Indices);

    [Theory]
    [InlineData("v 1 2 3 1.0")]
    [InlineData("v 1 2 3 0.5 0.5 0.5")]
    [InlineData("v +1 .2e1 3.")]
    [InlineData("v 1 2 3 nan -nan(ind) Infinity")]
    [InlineData("v 1 2 3 1.#QNAN -1.#IND 1.#INF000")]
    [InlineData("v 1 2 3 1e400 -1e999")]
    [InlineData("v 1 2 3.#in the comment")]
    [InlineData("v 1e0 20E-1 0.3e+1")]
    public void ExtraNumbersOfAVertexAreSkipped(string vertex) => Assert.Equal(new(1, 2, 3), Read(vertex + "\nf 1 1 1\n").Vertices[0]);

    /// <summary>Statements that may shape the mesh are not skipped in silence; those of looks and names are.</summary>
    [Theory]
    [InlineData("surf 0 1 0 1 1 2 3\n",
        "1 line of 1 unknown kind is skipped ('surf'), first in line 6 of the file; free-form curves and surfaces are not read")]
    [InlineData("face 1 2 3\n\nF 1 2 3\nface 1 2 3\n", "3 lines of 2 unknown kinds are skipped ('face', 'F'), first in line 6 of the file")]
    [InlineData("call part.obj\nusemtl red\n", "the file's materials are ignored; \"color\" colours the whole mesh; "
        + "1 line of 1 unknown kind is skipped ('call'), first in line 6 of the file")]
    [InlineData("<<<<<<< HEAD\nv 1 1 1\n=======\nv 2 2 2\n>>>>>>> other\n", "3 lines of 3 unknown kinds are skipped "
        + "('<<<<<<<', '=======', '>>>>>>>'), first in line 6 of the file; this is an unfinished merge of git")]
    [InlineData("g a\no b\ns off\nmg 1 1\nvt 0 0\nvn 0 0 1\nlod 3\nbevel on\nl 1 2\n# x\n", null)]
    public void StatementsThatAreNotKnownAreCounted(string statements, string? warning) =>
        Assert.Equal(warning, Read(fourVertices + "f 1 2 3\n" + statements).Warning);

    [Fact]
    public void Utf16IsNamed() => Assert.Equal("box.obj(1): the file is in UTF-16; save it as UTF-8",
        Assert.Throws<ProblemException>(() => MeshBytes.Read("box.obj", [0xFF, 0xFE, (byte)'v', 0])).Message);

    public static TheoryData<byte[], string> OtherKinds => new()
    {
        {
            [0x64, 0x86, 5, 0, 0, 0, 0, 0x5F, .. new byte[60]],
            "it is a compiled object file (COFF), as Visual Studio makes them, and not an OBJ mesh as its name says"
        },
        { [0x4C, 0x01, 3, 0, .. new byte[60]],
            "it is a compiled object file (COFF), as Visual Studio makes them, and not an OBJ mesh as its name says" },
        { [0x80, 9, 0, 7, .. "hello.c"u8, 0], "it is no text, and so no OBJ mesh; compiled files have the same extension" },
        { [.. "PK"u8, 3, 4, 20, 0], "it is a zip archive; unpack it first, and not an OBJ mesh as its name says" },
        { [.. "ply\nformat ascii 1.0\n"u8], "it is a PLY mesh, and not an OBJ mesh as its name says" },
        { [.. "solid cube\nfacet"u8], "it is an STL mesh, and not an OBJ mesh as its name says" },
        { [.. "<html><body>404"u8], "it is a web page (HTML), saved in place of the file, and not an OBJ mesh as its name says" },
    };

    [Theory]
    [MemberData(nameof(OtherKinds))]
    public void AnotherKindOfFileIsNamed(byte[] bytes, string message) =>
        Assert.Equal("box.obj: " + message, Assert.Throws<ProblemException>(() => MeshBytes.Read("box.obj", bytes)).Message);

    // A polygon with one corner that goes inwards, D; E and B see all of it, A does not.
    private const string notch = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 0.5 0\nv 0 2 0\n";

    [Theory]
    [InlineData(notch + "f 1 2 3 4 5\n", "the face in line 6 ")]
    [InlineData("f 1 2 3 4 5\n" + notch, "the face in line 1 ")]
    [InlineData(notch + "f 4 5 1 2 3\n", null)] // begun at the corner that sees all of it, the fan is right
    [InlineData(notch + "f 5 4 3 2 1\n", "the face in line 6 ")]
    [InlineData("v 0 0 0\nv 1 0 0\nv 1 1 0.2\nv 0 1 -0.1\nf 1 2 3 4\n", null)] // not flat, but convex
    [InlineData(fourVertices + "f 1 2 3 4 4\n", null)]
    public void AFaceOfAnotherShapeThanItsFanIsWarnedOf(string text, string? face)
    {
        var warning = Read(text).Warning;
        if (face is null) Assert.Null(warning);
        else
            Assert.Equal(face + "is not convex: split as a fan from its first corner it becomes another shape; "
                + "begin it at another corner, or split it into triangles", warning);
    }

    [Fact]
    public void OfManySuchFacesTheFirstIsNamed() => Assert.EndsWith(
        "the face in line 6 is not convex: split as a fan from its first corner it becomes "
        + "another shape; begin it at another corner, or split it into triangles, as 2 other faces",
        Read(notch + "f 1 2 3 4 5\nf 1 2 3\nf 1 2 3 4 5\nf 1 2 3 4 5\nusemtl a\n").Warning);

    private static MeshData Read(string text) => PiecesTests.ReadInPieces("box.obj", Encoding.ASCII.GetBytes(text));

    [Theory]
    [InlineData("f 1 2 3\nf 2 3 4\n", true)] // a larger object
    [InlineData("f 1 2 3\n", true)]
    [InlineData("f 4 5 6\nf 5 6 7\n", false)]
    [InlineData("f 4 5 6\n", false)] // one vertex belongs to no face
    [InlineData("f -4 -3 -2\n", false)]
    [InlineData("f 1 2 7\n", false)] // it shares vertices with the first object
    [InlineData("f 1 2 3\nl 4 5 6 7\n", false)]
    public void NumbersThatBeginAnewInEachObjectAreReported(string faces, bool isReported) => Assert.Equal(isReported,
        Read("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nv 5 0 0\nv 6 0 0\nv 5 1 0\nv 6 1 0\n" + faces).Warning?.Contains("begin at 1?") == true);
}
