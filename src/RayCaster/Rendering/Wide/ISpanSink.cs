namespace RayCaster;

/// <summary>Takes what the parts of a picture come to, in any order and from any thread.</summary>
internal interface ISpanSink
{
    /// <summary>Takes the hits of a span, before the next span is cast into it.</summary>
    void Take(RaySpan span);

    /// <summary>Takes a part in which no ray hits anything.</summary>
    void TakeMiss(in Tile part);

    /// <summary>Takes a part in which every ray's nearest hit is one of the same model.</summary>
    /// <param name="covered">The part.</param>
    /// <param name="view">The model's view, which is a covering one.</param>
    /// <param name="index">The model's place in the scene.</param>
    void TakeCover(CoveredPart covered, ModelView view, int index);

    /// <summary>Is offered a tile in which one model alone may show; whether it takes it without the hits.</summary>
    /// <param name="tile">The tile.</param>
    /// <param name="view">The model's view, which has come to the tile.</param>
    /// <param name="index">The model's place in the scene.</param>
    bool TryTake(in Tile tile, ModelView view, int index);
}
