namespace RayCaster.Engine;

/// <summary>One thread's consumer of hits: takes what the parts of a picture come to, in any order.</summary>
internal interface ISpanSink
{
    /// <summary>Takes the hits of a span, before the next span is cast into it.</summary>
    void Take(RaySpan span);

    /// <summary>Takes a part in which no ray hits anything.</summary>
    void TakeMiss(in Tile part);

    /// <summary>Offers a part that shapes fully cover; returns whether the consumer can do it without the hits.</summary>
    /// <param name="covered">The part; a small one if there are several shapes.</param>
    bool TryTake(CoveredPart covered);

    /// <summary>Offers a tile in which one model alone may show; returns whether the consumer lets the model's view paint it.</summary>
    /// <param name="tile">The tile.</param>
    /// <param name="view">The model's view, which has entered the tile.</param>
    /// <param name="index">The model's place in the scene.</param>
    bool TryTake(in Tile tile, ITileView view, int index);
}
