namespace RayCaster.Engine;

/// <summary>Consecutive triangles of a mesh, which in most meshes are neighbours, as they show in a tile.</summary>
/// <param name="MaxInverseDepth">The greatest inverse depth of a sample that they cover.</param>
/// <param name="Cells">The cells of the tile (<see cref="CoarseDepth"/>) in which they may cover samples.</param>
internal readonly record struct TriangleCluster(TriangleRun Run, float MaxInverseDepth, Cells Cells)
{
    /// <summary>The number of triangles in a cluster, and in one of a mesh whose clusters would be large on the screen.</summary>
    public const int Length = 16, ShortLength = 8;
}

/// <summary>Consecutive triangles of a mesh: a cluster, which may reach beyond the mesh's end, or a single one.</summary>
internal readonly struct TriangleRun(int first, int count)
{
    private readonly uint code = (uint)first << 2 | (uint)count / TriangleCluster.ShortLength; // four bytes, since millions are sorted

    public int First => (int)(code >> 2);

    public int Count => Math.Max(1, (int)(code & 3) * TriangleCluster.ShortLength);
}
