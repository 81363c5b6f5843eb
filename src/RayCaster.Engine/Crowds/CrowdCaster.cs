using System.Runtime.Intrinsics;

namespace RayCaster.Engine;

/// <summary>One thread's tool: casts the tiles of a scene with a crowd.</summary>
internal sealed class CrowdCaster(Crowd crowd, Camera camera)
{
    private readonly CrowdPart part = new(camera);
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
        var (firstColumn, firstRow) = (tile.Column / CrowdPart.Side * CrowdPart.Side, tile.Row / CrowdPart.Side * CrowdPart.Side);
        for (var y = firstRow; y < tile.EndRow; y += CrowdPart.Side)
        {
            for (var x = firstColumn; x < tile.EndColumn; x += CrowdPart.Side)
            {
                var (column, row) = (Math.Max(x, tile.Column), Math.Max(y, tile.Row));
                var inner = new Tile(column, row, Math.Min(x + CrowdPart.Side, tile.EndColumn) - column, Math.Min(y + CrowdPart.Side, tile.EndRow) - row);
                if (Vector512.IsHardwareAccelerated) Cast<WidePacket>(inner, others, sink);
                else Cast<Packet>(inner, others, sink);
            }
        }
    }

    private void Cast<N>(in Tile tile, Action<RaySpan>? others, ISpanSink sink) where N : struct, IPacket<N>
    {
        crowd.Sort(tile, order);
        if (order.Sorted.Length == 0 && others is null)
        {
            sink.TakeMiss(tile);
            return;
        }
        part.Enter<N>(tile);
        if (others is not null) MeetOthers<N>(tile, others);
        part.RefreshAll<N>();
        crowd.Meet<N>(part, order.Sorted);
        sink.Take(part.Rays);
    }

    /// <summary>Row by row, since not every view can meet several rows at once.</summary>
    private void MeetOthers<N>(in Tile tile, Action<RaySpan> others) where N : struct, IPacket<N>
    {
        row.Enter<N>(tile.Column, tile.Width);
        for (var i = 0; i < tile.Height; i++)
        {
            row.Aim<N>(tile.Row + i);
            others(row);
            part.Take<N>(row);
        }
    }
}
