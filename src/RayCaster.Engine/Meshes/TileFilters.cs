namespace RayCaster.Engine;

/// <summary>One thread's filters, which the meshes of a tile share: each has about 100 kB, and a scene may have thousands of meshes. A tile
/// with more meshes than there are filters takes longer: a mesh whose filter was given to another mesh must be rasterized again.</summary>
internal sealed class TileFilters<N> where N : struct, IPacket<N>
{
    private const int Most = 32;

    private readonly List<TileFilter<N>> filters = []; // a ring: the next one was taken longest ago
    private int next;
    private (int Index, MeshPainter Painter)? painter;

    /// <summary>A filter for a mesh in a tile: one that is not used in this tile, or a new one; with too many, the one taken longest ago.</summary>
    public TileFilter<N> Take(ScreenSpace screen, in PixelRect tile)
    {
        if (next == filters.Count) next = 0;
        var isFree = filters.Count > 0 && (filters[next].Owner is null || filters[next].Rect != tile);
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
