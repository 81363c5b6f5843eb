using System.Runtime.Intrinsics;

namespace RayCaster;

/// <summary>One thread's tool: casts the tiles of a scene with a crowd.</summary>
internal sealed class CrowdCaster(Crowd crowd, Camera camera)
{
    private readonly CrowdPart part = new(camera);
    private readonly GrowingArray<int> merged = new();

    /// <summary>Casts all rays of a tile.</summary>
    /// <param name="tile">The tile.</param>
    /// <param name="others">Lets the rays of a span meet the models that are not in the crowd.</param>
    /// <param name="sink">Takes the spans.</param>
    public void Cast(in Tile tile, Action<RaySpan> others, ISpanSink sink)
    {
        var (firstColumn, firstRow) = (tile.Column / CrowdPart.Side * CrowdPart.Side, tile.Row / CrowdPart.Side * CrowdPart.Side);
        for (var y = firstRow; y < tile.EndRow; y += CrowdPart.Side)
        {
            for (var x = firstColumn; x < tile.EndColumn; x += CrowdPart.Side)
            {
                var (column, row) = (Math.Max(x, tile.Column), Math.Max(y, tile.Row));
                Cast(new(column, row, Math.Min(x + CrowdPart.Side, tile.EndColumn) - column, Math.Min(y + CrowdPart.Side, tile.EndRow) - row), others);
                for (var i = 0; i < part.Tile.Height; i++) sink.Take(part.Rows[i]);
            }
        }
    }

    private void Cast(in Tile tile, Action<RaySpan> others)
    {
        if (Vector512.IsHardwareAccelerated) part.Enter<WidePacket>(tile);
        else part.Enter<Packet>(tile);
        for (var i = 0; i < tile.Height; i++) others(part.Rows[i]);
        crowd.Meet(part, crowd.MembersOf(tile, merged));
    }
}
