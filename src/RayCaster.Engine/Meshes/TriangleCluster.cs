namespace RayCaster.Engine;

/// <summary>Triangles that follow one another in a mesh, as they show in a tile. Most meshes hold neighbours side by side.</summary>
/// <param name="First">The first of them.</param>
/// <param name="MostW">No sample that they cover has a greater w.</param>
/// <param name="Cells">The cells of the tile (<see cref="CoarseDepth"/>) in which they may cover samples.</param>
internal readonly record struct TriangleCluster(int First, float MostW, Cells Cells)
{
    public const int Length = 16;
}
