namespace RayCaster.Engine;

/// <summary>Casts the tiles of a scene with a batch; each thread has its own.</summary>
internal sealed class BatchCaster<N>(PrimitiveBatch<N> batch, Camera camera) where N : struct, IPacket<N>
{
    private const int Side = ScreenBins.PartSide;

    private readonly BatchTile<N> part = new(camera);
    private readonly RayStream row = new(camera);
    private readonly DepthOrder order = new();

    /// <summary>Whether members may show in a tile.</summary>
    public bool IsFor(in PixelRect tile) => batch.Shows(tile, order);

    /// <param name="others">Intersects a stream with the models that are not in the batch; null if there are none.</param>
    public void Cast(in PixelRect tile, Action<RayStream>? others, IHitConsumer consumer)
    {
        var (firstColumn, firstRow) = (tile.Column / Side * Side, tile.Row / Side * Side);
        for (var y = firstRow; y < tile.EndRow; y += Side)
        {
            for (var x = firstColumn; x < tile.EndColumn; x += Side)
            {
                var (column, row) = (Math.Max(x, tile.Column), Math.Max(y, tile.Row));
                var inner = new PixelRect(column, row, Math.Min(x + Side, tile.EndColumn) - column, Math.Min(y + Side, tile.EndRow) - row);
                CastPart(inner, others, consumer);
            }
        }
    }

    private void CastPart(in PixelRect tile, Action<RayStream>? others, IHitConsumer consumer)
    {
        batch.Sort(tile, order);
        if (order.Sorted.Length == 0 && others is null)
        {
            consumer.FillBackground(tile);
            return;
        }
        part.Begin(tile);
        if (others is not null) MeetOthers(tile, others);
        part.Refresh();
        batch.Intersect(part, order.Sorted);
        consumer.Consume(part.Rays);
    }

    /// <summary>Row by row, since some views cannot intersect several rows at once.</summary>
    private void MeetOthers(in PixelRect tile, Action<RayStream> others)
    {
        row.Begin<N>(tile.Column, tile.Width);
        for (var i = 0; i < tile.Height; i++)
        {
            row.Aim<N>(tile.Row + i);
            others(row);
            part.CopyHits(row);
        }
    }
}
