namespace RayCaster.Engine;

/// <summary>Consecutive triangles of a mesh, which in most meshes are neighbours, or a single one, as they show in a tile.</summary>
/// <param name="First">The first of them.</param>
/// <param name="MostW">The greatest w of a sample that they cover.</param>
/// <param name="Cells">The cells of the tile (<see cref="CoarseDepth"/>) in which they may cover samples.</param>
internal readonly record struct TriangleCluster(int First, float MostW, Cells Cells)
{
    /// <summary>The number of triangles in a cluster.</summary>
    public const int Length = 16;
}
