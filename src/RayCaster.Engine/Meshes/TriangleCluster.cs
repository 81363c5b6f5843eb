namespace RayCaster.Engine;

/// <summary>Consecutive triangles of a mesh, as they show in a tile. In most meshes they are neighbours.</summary>
/// <param name="First">The first of them.</param>
/// <param name="MostW">The greatest w of a sample that they cover.</param>
/// <param name="Cells">The cells of the tile (<see cref="CoarseDepth"/>) in which they may cover samples.</param>
internal readonly record struct TriangleCluster(int First, float MostW, Cells Cells)
{
    public const int Length = 16;
}
