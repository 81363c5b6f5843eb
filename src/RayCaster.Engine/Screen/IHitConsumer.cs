namespace RayCaster.Engine;

/// <summary>Consumes the hits of the parts of a picture, in any order; each thread has its own.</summary>
internal interface IHitConsumer
{
    /// <summary>Takes the hits of a stream, before the next stream is cast into it.</summary>
    void Consume(RayStream rays);

    /// <summary>Fills a part without any hit.</summary>
    void FillBackground(in PixelRect part);

    /// <summary>Offers a part that one shape covers; returns whether the consumer can do it without exact hits.</summary>
    bool PaintCovered(in CoveredTile covered);

    /// <summary>Offers a tile in which only one model may show; returns whether the model's view has painted it.</summary>
    bool PaintMesh(in PixelRect tile, ModelView view, int index);
}
