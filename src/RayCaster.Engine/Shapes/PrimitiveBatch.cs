namespace RayCaster.Engine;

/// <summary>Many models with bounds, as a camera sees them. A part of the picture finds them by their rectangles, the nearest first, so that most
/// others are hidden before their formula is computed.</summary>
internal sealed class PrimitiveBatch<N> where N : struct, IPacket<N>
{
    private const int Batch = DepthOrder.Batch;

    private readonly BatchShapes<N>[] groups;
    private readonly ScreenBins grid;
    private readonly PooledList<BatchItem> members = new(); // in the order of the bins

    /// <summary>Finds where in the picture models may show.</summary>
    public PrimitiveBatch(Camera camera, ShapeLists shapes, int count, int threads)
    {
        groups = [.. shapes.Lists.Select(list => list.ForBatch<N>(camera.ClipRange))];
        grid = new(camera);
        var shares = ThreadTeam.SharesOf(count, threads);
        var found = new PooledList<BatchItem>[shares];
        var unknown = new List<int>[shares];
        ThreadTeam.Each(shares, shares, share =>
        {
            (found[share], unknown[share]) = (new(), []);
            found[share].Reserve(count / shares + ScreenBounds.Count);
            var screenBounds = new ScreenBounds(camera);
            for (var i = 0; i < groups.Length; i++) groups[i].AddTo(found[share], unknown[share], screenBounds, i, share, shares);
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

    /// <summary>The indices of the models that are not members: those without bounds, and those that reach to the eye's plane.</summary>
    public IReadOnlyList<int> Others { get; }

    /// <summary>Whether members may show in a tile.</summary>
    public bool Shows(in PixelRect tile, DepthOrder order)
    {
        grid.Find(tile, order.Ranges);
        return order.Ranges.Count > 0;
    }

    /// <summary>Sorts the members that may show in a part of the picture.</summary>
    public void Sort(in PixelRect part, DepthOrder order)
    {
        grid.Find(part, order.Ranges);
        order.Sort(members.Items, part);
    }

    /// <summary>Returns the memory; no more pictures can be drawn.</summary>
    public void Free()
    {
        members.Free();
        foreach (var group in groups) group.Free();
    }

    /// <summary>Intersects the rays of a part with members, in their order.</summary>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    public void Intersect(BatchTile<N> part, ReadOnlySpan<(int Member, float NearestOfRest)> order)
    {
        var members = this.members.Items;
        // one call for members of one kind, which nearly always is the whole batch
        var group = 0;
        var isClear = false;
        for (var next = 0; next < order.Length && !part.Hides(order[next].NearestOfRest); next += Batch)
        {
            for (var i = next + Batch; i < Math.Min(next + 2 * Batch, order.Length); i++) // the batch that follows
            {
                var member = order[i].Member;
                groups[members[member].Kind].Prefetch(member);
            }
            var (first, end) = (0, 0);
            for (var i = next; i < Math.Min(next + Batch, order.Length); i++)
            {
                ref readonly var member = ref members[order[i].Member];
                if (member.Kind != group || member.IsClear != isClear)
                {
                    groups[group].Intersect(part, first, end, isClear);
                    (first, group, isClear) = (end, member.Kind, member.IsClear);
                }
                end = part.List(member, order[i].Member);
            }
            groups[group].Intersect(part, first, end, isClear);
            part.Refresh();
        }
    }
}
