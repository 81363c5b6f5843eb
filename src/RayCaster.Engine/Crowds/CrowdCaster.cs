namespace RayCaster.Engine;

/// <summary>One thread's tool: casts the tiles of a scene with a crowd.</summary>
/// <typeparam name="N">The kind of packet to compute with.</typeparam>
internal sealed class CrowdCaster<N>(Crowd<N> crowd, Camera camera) where N : struct, IPacket<N>
{
    private const int Side = CrowdGrid.PartSide;

    private readonly CrowdPart<N> part = new(camera);
    private readonly RaySpan row = new(camera);
    private readonly CrowdOrder order = new();

    /// <summary>Whether members of the crowd may show in a tile.</summary>
    public bool IsFor(in Tile tile) => crowd.Shows(tile, order);

    /// <summary>Casts all rays of a tile.</summary>
    /// <param name="tile">The tile.</param>
    /// <param name="others">Lets the rays of a span meet the models that are not in the crowd; null where there are none.</param>
    /// <param name="sink">Takes the spans.</param>
    public void Cast(in Tile tile, Action<RaySpan>? others, ISpanSink sink)
    {
        var (firstColumn, firstRow) = (tile.Column / Side * Side, tile.Row / Side * Side);
        for (var y = firstRow; y < tile.EndRow; y += Side)
        {
            for (var x = firstColumn; x < tile.EndColumn; x += Side)
            {
                var (column, row) = (Math.Max(x, tile.Column), Math.Max(y, tile.Row));
                var inner = new Tile(column, row, Math.Min(x + Side, tile.EndColumn) - column, Math.Min(y + Side, tile.EndRow) - row);
                CastPart(inner, others, sink);
            }
        }
    }

    private void CastPart(in Tile tile, Action<RaySpan>? others, ISpanSink sink)
    {
        crowd.Sort(tile, order);
        if (order.Sorted.Length == 0 && others is null)
        {
            sink.TakeMiss(tile);
            return;
        }
        part.Enter(tile);
        if (others is not null) MeetOthers(tile, others);
        part.RefreshAll();
        crowd.Meet(part, order.Sorted);
        sink.Take(part.Rays);
    }

    /// <summary>Row by row, since not every view can meet several rows at once.</summary>
    private void MeetOthers(in Tile tile, Action<RaySpan> others)
    {
        row.Enter<N>(tile.Column, tile.Width);
        for (var i = 0; i < tile.Height; i++)
        {
            row.Aim<N>(tile.Row + i);
            others(row);
            part.Take(row);
        }
    }
}
