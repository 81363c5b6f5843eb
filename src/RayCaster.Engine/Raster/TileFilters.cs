namespace RayCaster.Engine;

/// <summary>One thread's filters, for all meshes. A filter has about 100 kB, and a tile may show thousands of meshes; so there are only two: the
/// pixels of the last mesh that shows in a tile are kept while others are looked for.</summary>
internal sealed class TileFilters<N>(ScreenSpace screen) where N : struct, IPacket<N>
{
    private TileFilter<N>? next, kept;
    private (int Index, MeshPainter Painter)? painter;

    public TileFilter<N> Next => next ??= new(screen);

    /// <summary>Keeps the pixels of that filter until those of another one are kept.</summary>
    public void Keep() => (next, kept) = (kept, next);

    /// <summary>What paints tiles in which nothing but one mesh shows.</summary>
    public MeshPainter PainterOf(Scene scene, int index)
    {
        if (painter is not var (known, same) || known != index) painter = (index, same = new(screen, scene, index));
        return same;
    }
}
