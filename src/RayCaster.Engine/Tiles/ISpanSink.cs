namespace RayCaster.Engine;

/// <summary>Takes what the parts of a picture come to, in any order and from any thread.</summary>
internal interface ISpanSink
{
    /// <summary>Takes the hits of a span, before the next span is cast into it.</summary>
    void Take(RaySpan span);

    /// <summary>Takes a part in which no ray hits anything.</summary>
    void TakeMiss(in Tile part);

    /// <summary>Is offered a part that some shapes cover; whether it takes it without the hits.</summary>
    /// <param name="covered">The part; a small one if there are several shapes.</param>
    bool TryTake(CoveredPart covered);

    /// <summary>Is offered a tile in which one model alone may show; whether it lets the model's view finish it.</summary>
    /// <param name="tile">The tile.</param>
    /// <param name="view">The model's view, which has come to the tile.</param>
    /// <param name="index">The model's place in the scene.</param>
    bool TryTake(in Tile tile, ModelView view, int index);
}
