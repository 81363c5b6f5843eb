namespace RayCaster.Engine;

/// <summary>Finds what the rays of a strip of the picture hit; each thread has its own.</summary>
internal interface IStripCaster
{
    /// <summary>Casts all rays of a strip.</summary>
    /// <param name="strip">Up to eight tiles side by side; none crosses a multiple of <see cref="Tile.MaxSide"/>.</param>
    void Cast(in Tile strip, IHitConsumer consumer);
}
