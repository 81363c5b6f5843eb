namespace RayCaster;

/// <summary>One thread's tool to find what the rays of a strip of the picture hit.</summary>
internal interface IStripCaster
{
    /// <summary>Casts all rays of a strip.</summary>
    /// <param name="strip">Up to eight tiles side by side, each at multiples of <see cref="Tile.MaxSide"/> and at most as large.</param>
    /// <param name="sink">Takes the hits.</param>
    void Cast(in Tile strip, ISpanSink sink);
}
