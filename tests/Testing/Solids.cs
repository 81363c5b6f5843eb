namespace RayCaster.Testing;

/// <summary>Closed meshes around the origin.</summary>
internal static class Solids
{
    /// <summary>The cube from (−1, −1, −1) to (1, 1, 1), two triangles to a face.</summary>
    public static Mesh Cube() => Of(MeshGenerator.Cube(half: 1));

    /// <summary>A ball of radius 1 of 20 · 4ⁿ triangles.</summary>
    public static Mesh Icosphere(int n) => Of(MeshGenerator.Icosphere(n));

    private static Mesh Of(MeshData data) => new(data.Vertices, data.Indices);
}
