namespace RayCaster.Engine;

/// <summary>
/// One thread's filters, which the meshes of a tile share: each has a tenth of a megabyte, and a scene may have thousands of meshes. A tile with more meshes than
/// there are filters takes longer: who finds its filter in other hands enters the tile anew.
/// </summary>
internal sealed class TileFilters
{
    private const int Most = 32;

    private readonly List<TileFilter> filters = []; // from the next on in the order in which they were taken
    private int next;
    private (int Index, MeshPainter Painter)? painter;

    /// <summary>A filter for a mesh in a tile: one that another tile left, a new one, or, of many, the one that was taken first.</summary>
    public TileFilter Take(ScreenSpace screen, in Tile tile)
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
