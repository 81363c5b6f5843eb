namespace RayCaster.Engine;

/// <summary>One thread's tool to find what the rays of a strip of the picture hit.</summary>
internal interface IStripCaster
{
    /// <summary>Casts all rays of a strip.</summary>
    /// <param name="strip">Up to eight tiles side by side, none of which reaches over a multiple of <see cref="Tile.MaxSide"/>.</param>
    /// <param name="sink">Takes the hits.</param>
    void Cast(in Tile strip, ISpanSink sink);
}
