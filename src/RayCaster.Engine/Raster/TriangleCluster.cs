namespace RayCaster.Engine;

/// <summary>Consecutive triangles of a mesh (a meshlet), which in most meshes are neighbours, as they show in a tile.</summary>
/// <param name="MaxInverseDepth">The greatest inverse depth of a sample that they cover.</param>
/// <param name="Cells">The cells of the tile (<see cref="CoarseDepth"/>) in which they may cover samples.</param>
internal readonly record struct TriangleCluster(TriangleRun Run, float MaxInverseDepth, Cells Cells);

/// <summary>Consecutive triangles of a mesh: a cluster, which may reach beyond the mesh's end, or a single one.</summary>
internal readonly struct TriangleRun(int first, int count)
{
    private readonly uint code = (uint)first << 1 | (uint)count / TriangleBoxes.ClusterLength; // four bytes, since millions are sorted

    public int First => (int)(code >> 1);

    public int Count => (code & 1) == 0 ? 1 : TriangleBoxes.ClusterLength;
}
