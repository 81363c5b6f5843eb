using System.Text;

namespace RayCaster.Files.Tests.Scenes;

/// <summary>Meshes whose triangles stand in the scene file.</summary>
public class InlineMeshTests
{
    private const string Vertices = "\"vertices\": [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]";

    [Fact]
    public void PolygonsAreSplitAndPlacedLikeThoseOfAFile()
    {
        var mesh = (Mesh)Read(Vertices + ", \"faces\": [[0, 1, 2, 3], [3.0, 1, 0]], \"scale\": 2, \"translate\": [0, 0, 5]").Scene!.Models[0];
        Assert.Equal([0, 1, 2, 0, 2, 3, 3, 1, 0], mesh.Indices);
        Assert.Equal([new(0, 0, 5), new(2, 0, 5), new(2, 2, 5), new(0, 2, 5)], mesh.Vertices);
    }

    [Fact]
    public void TrianglesWithoutAnAreaAreDropped()
    {
        var reading = Read(Vertices + ", \"faces\": [[0, 1, 2], [0, 1, 1]]");
        Assert.Equal("models[0].faces: 1 of 2 triangles have no area and are dropped", Assert.Single(reading.Problems).Message);
        Assert.Equal([0, 1, 2], ((Mesh)reading.Scene!.Models[0]).Indices);
    }

    [Fact]
    public void AFaceOfAnotherShapeThanItsFanIsWarnedOf()
    {
        var reading = Read("\"vertices\": [[0,0,0], [2,0,0], [2,2,0], [1,0.5,0], [0,2,0]], " +
            "\"faces\": [[0, 1, 2], [3, 4, 0, 1, 2], [0, 1, 2, 3, 4]]");
        Assert.StartsWith("models[0].faces[2] is not convex: split as a fan", Assert.Single(reading.Problems).Message);
        Assert.NotNull(reading.Scene);
    }

    [Theory]
    [InlineData(Vertices + ", \"faces\": [[0, 1, 2], [0, 1, 4]]", ".faces[1][2] must be from 0 to 3, but is 4")]
    [InlineData(Vertices + ", \"faces\": [[0, 1, -1]]", ".faces[0][2] must be from 0 to 3, but is -1")]
    [InlineData(Vertices + ", \"faces\": [[0, 1, 0.5]]", ".faces[0][2] must be a whole number, but is 0.5")]
    [InlineData(Vertices + ", \"faces\": [[0, 1, 2], [0, 1]]", ".faces[1] must have at least three indices, but has 2")]
    [InlineData(Vertices + ", \"faces\": [0, 1, 2]", ".faces[0] must be an array of indices in brackets [ ], but is 0", 3)]
    [InlineData(Vertices + ", \"faces\": []", ".faces must have at least one face")]
    [InlineData(Vertices, ".vertices needs faces beside it")]
    [InlineData("\"faces\": [[0, 1, 2]]", ".faces needs vertices beside it")]
    [InlineData("\"vertices\": [], \"faces\": [[0, 1, 2]]", ".vertices must have at least one vertex")]
    [InlineData("\"vertices\": 1, \"faces\": [[0, 1, 2]]", ".vertices must be an array of vectors in brackets [ ], but is 1")]
    [InlineData("\"vertices\": [[0, 0], [1, 0, 0]], \"faces\": [[0, 1, 0]]",
        ".vertices[0] must be an array of three numbers [x, y, z], but has 2 elements")]
    [InlineData("\"vertices\": [[0, 0, \"1\"]], \"faces\": [[0, 0, 0]]",
        ".vertices[0][2] must be a number, but is the text \"1\"; remove the quotes")]
    [InlineData("\"file\": \"a.obj\", " + Vertices + ", \"faces\": [[0, 1, 2]]",
        ".faces cannot stand beside models[0].file: a mesh has one or the other", 2)]
    [InlineData("\"scale\": 1", ".file is missing: a mesh file (.obj, .ply or .stl), or in place of it vertices and faces")]
    public void AMistakeIsNamedByItsPath(string keys, string message, int count = 1)
    {
        var reading = Read(keys);
        Assert.Null(reading.Scene);
        Assert.Contains("models[0]" + message, reading.Problems.Select(problem => problem.Message));
        Assert.Equal(count, reading.Problems.Count);
    }

    private static SceneReading Read(string keys) => SceneReader.Parse(Encoding.UTF8.GetBytes(
        "{ \"camera\": { \"position\": [5, 0, 0], \"target\": [0, 0, 0] }, \"models\": [ { \"type\": \"mesh\", " + keys + " } ] }"), "scene", ".");
}
