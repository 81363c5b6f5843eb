namespace RayCaster.Engine;

/// <summary>One thread's consumer of hits: takes what the parts of a picture come to, in any order.</summary>
internal interface IHitConsumer
{
    /// <summary>Takes the hits of a stream, before the next stream is cast into it.</summary>
    void Take(RayStream rays);

    /// <summary>Takes a part in which no ray hits anything.</summary>
    void TakeMiss(in Tile part);

    /// <summary>Offers a part that a shape fully covers; returns whether the consumer can do it without the hits.</summary>
    bool TryTake(in CoveredTile covered);

    /// <summary>Offers a tile in which one model alone may show; returns whether the consumer lets the model's view paint it.</summary>
    /// <param name="view">The model's view, which has entered the tile.</param>
    bool TryTake(in Tile tile, ITileView view, int index);
}
