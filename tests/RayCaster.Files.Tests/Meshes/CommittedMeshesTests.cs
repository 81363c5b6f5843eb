namespace RayCaster.Files.Tests.Meshes;

/// <summary>The files in scenes/meshes. <c>dotnet run --project tests/Tools/Generator</c> writes them again.</summary>
public class CommittedMeshesTests
{
    public static string[] Names => ["cube.stl", "icosphere.obj", "knot.ply"];

    [Theory]
    [InlineData("cube.stl", 12)]
    [InlineData("icosphere.obj", 320)]
    [InlineData("knot.ply", 5760)]
    public void CommittedMeshIsClosedAndHasNoSliver(string name, int triangles)
    {
        var mesh = MeshFile.Read(PathOf(name));
        Assert.Equal(triangles, mesh.Indices.Length / 3);
        Assert.Equal(triangles, new MeshPlacement(new(1, 1, 1), default, default).Place(mesh, out _).TriangleCount);

        // In a closed surface each side is walked once in each direction, by the two triangles that share it.
        var sides = new HashSet<(Vector3, Vector3)>();
        foreach (var (a, b, c) in MeshWriter.Triangles(mesh))
            foreach (var (from, to) in new[] { (a, b), (b, c), (c, a) })
                Assert.True(sides.Add((mesh.Vertices[from], mesh.Vertices[to])), "a side is walked twice in one direction");
        Assert.All(sides, side => Assert.Contains((side.Item2, side.Item1), sides));
    }

    [Theory]
    [InlineData("cube.stl", 8)] // 2³
    [InlineData("icosphere.obj", 4.047)] // computed by another program; the ball has 4π/3 = 4.189
    [InlineData("knot.ply", 0.6075 * 27.443)] // the area of the twelve-sided ring, 3 · 0.45², times the integral of |derivative of center|
    public void CommittedMeshFacesOutwardsAroundItsVolume(string name, double volume)
    {
        var mesh = MeshFile.Read(PathOf(name));
        var sum = 0d; // of the signed volumes of the tetrahedra between each triangle and the origin
        foreach (var (a, b, c) in MeshWriter.Triangles(mesh)) sum += mesh.Vertices[a] % mesh.Vertices[b] * mesh.Vertices[c] / 6;
        Assert.InRange(sum / volume, 0.99, 1.01);
    }

    internal static byte[] Make(string name) => name switch
    {
        "cube.stl" => MeshWriter.StlAscii(MeshGenerator.Cube(1), "cube"),
        "icosphere.obj" => MeshWriter.Obj(MeshGenerator.Icosphere(2), "F6"),
        _ => MeshWriter.PlyFloat(MeshGenerator.TorusKnot(2, 3, major: 1.85, minor: 0.75, tube: 0.45, rings: 240, sides: 12)),
    };

    internal static string PathOf(string name) => ProjectFolder.PathOf("scenes/meshes/" + name);
}
