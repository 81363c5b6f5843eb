namespace RayCaster.Engine;

/// <summary>One thread's filters, which the meshes of a tile share: each has a tenth of a megabyte, and a scene may have thousands of meshes. A tile
/// with more meshes than there are filters takes longer, for a mesh whose filter another one has taken enters the tile anew.</summary>
internal sealed class TileFilters<N> where N : struct, IPacket<N>
{
    private const int Most = 32;

    private readonly List<TileFilter<N>> filters = []; // from the next on in the order in which they were taken
    private int next;
    private (int Index, MeshPainter Painter)? painter;

    /// <summary>A filter for a mesh in a tile: one that another tile has left, or a new one; where there are many, the one taken first.</summary>
    public TileFilter<N> Take(ScreenSpace screen, in Tile tile)
    {
        if (next == filters.Count) next = 0;
        var isFree = filters.Count > 0 && (filters[next].Owner is null || filters[next].Tile != tile);
        if (!isFree && filters.Count < Most) filters.Insert(next, new(screen));
        return filters[next++];
    }

    /// <summary>What paints tiles in which nothing but one mesh shows.</summary>
    public MeshPainter PainterOf(ScreenSpace screen, Scene scene, int index)
    {
        if (painter is not var (known, same) || known != index) painter = (index, same = new(screen, scene, index));
        return same;
    }
}
