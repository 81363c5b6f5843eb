namespace RayCaster.Files;

/// <summary>What a mesh file holds, before a scene scales, turns and moves it.</summary>
/// <param name="Vertices">The corners, all finite, in file order.</param>
/// <param name="Indices">Three places in <paramref name="Vertices"/> for each triangle, in file order; polygons are already split.</param>
public sealed record MeshData(Vector3[] Vertices, int[] Indices)
{
    /// <summary>What was ignored in the file.</summary>
    internal string? Warning { get; init; }
}
