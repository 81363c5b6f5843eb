using System.Runtime.CompilerServices;

namespace RayCaster.Engine;

/// <summary>Many models with bounds, as a camera sees them: found by their rectangles in the picture, the nearest first, so that each hides most of
/// those behind it before their formula is asked.</summary>
internal sealed class PrimitiveBatch<N> where N : struct, IPacket<N>
{
    private const int Batch = DepthOrder.Batch;

    private readonly BatchShapes<N>[] groups;
    private readonly ScreenBins grid;
    private readonly PooledList<BatchItem> members = new(); // in the order of the grid's cells

    /// <summary>Finds where in the picture models may show.</summary>
    public PrimitiveBatch(Camera camera, ShapeLists shapes, int count, int threads)
    {
        groups = [.. shapes.Lists.Select(list => list.ForBatch<N>(camera.ClipRange))];
        grid = new(camera);
        var shares = ThreadTeam.SharesOf(count, threads);
        var (found, unknown) = (new PooledList<BatchItem>[shares], new List<int>[shares]);
        ThreadTeam.Each(shares, shares, share =>
        {
            (found[share], unknown[share]) = (new(), []);
            found[share].Reserve(count / shares + ScreenBounds.Count);
            var outlines = new ScreenBounds(camera);
            for (var i = 0; i < groups.Length; i++) groups[i].AddTo(found[share], unknown[share], outlines, i, share, shares);
        });
        grid.Sort(found, members);
        foreach (var some in found) some.Free();
        foreach (var group in groups) group.Reserve(members.Count);
        ThreadTeam.Shares(shares, members.Count, (_, first, end) =>
        {
            for (var i = 0; i < groups.Length; i++) groups[i].Arrange(members.Items, i, first, end);
        });
        Others = [.. shapes.Others, .. unknown.SelectMany(some => some)];
    }

    /// <summary>The places of the models that are not members: those without bounds, and those of which nothing can be said in advance, since they
    /// reach to the eye's plane.</summary>
    public IReadOnlyList<int> Others { get; }

    /// <summary>Whether members may show in a tile.</summary>
    public bool Shows(in Tile tile, DepthOrder order)
    {
        grid.Find(tile, order.Ranges);
        return order.Ranges.Count > 0;
    }

    /// <summary>Puts the members that may show in a part of the picture in order.</summary>
    public void Sort(in Tile part, DepthOrder order)
    {
        grid.Find(part, order.Ranges);
        order.Sort(members.Items, part);
    }

    /// <summary>Gives the memory back; no more pictures can be drawn.</summary>
    public void Free()
    {
        members.Free();
        foreach (var group in groups) group.Free();
    }

    /// <summary>Lets the rays of a part meet members, in their order.</summary>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    public void Meet(BatchTile<N> part, ReadOnlySpan<(int Member, float NearestOfRest)> order)
    {
        var members = this.members.Items;
        var (group, isClear) = (0, false); // those of one kind, nearly always the whole batch, are met in one call
        for (var next = 0; next < order.Length && !part.Hides(order[next].NearestOfRest); next += Batch)
        {
            for (var i = next + Batch; i < Math.Min(next + 2 * Batch, order.Length); i++) // the batch that follows
            {
                var member = order[i].Member;
                groups[members[member].Kind].Fetch(member);
            }
            var (first, end) = (0, 0);
            for (var i = next; i < Math.Min(next + Batch, order.Length); i++)
            {
                ref readonly var member = ref members[order[i].Member];
                if (member.Kind != group || member.IsClear != isClear)
                {
                    groups[group].Meet(part, first, end, isClear);
                    (first, group, isClear) = (end, member.Kind, member.IsClear);
                }
                end = part.List(member, order[i].Member);
            }
            groups[group].Meet(part, first, end, isClear);
            part.Refresh();
        }
    }
}
