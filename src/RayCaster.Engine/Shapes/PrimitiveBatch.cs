namespace RayCaster.Engine;

/// <summary>Many models with bounds, as a camera sees them. A part of the picture finds them by their rectangles, the nearest first, so that most
/// others are hidden before their formula is computed.</summary>
internal sealed class PrimitiveBatch<N> where N : struct, IPacket<N>
{
    private readonly BatchShapes<N>[] groups;
    private readonly ScreenBins grid;
    private readonly Bins<BatchItem> members;

    /// <summary>Finds where in the picture models may show.</summary>
    public PrimitiveBatch(Camera camera, ShapeLists shapes, int models, int threads)
    {
        groups = [.. shapes.Lists.Select(list => list.ForBatch<N>(camera.ClipRange))];
        grid = new(camera);
        var shares = ThreadTeam.SharesOf(models, threads);
        var found = new PooledList<(int Bin, BatchItem Item)>[shares];
        var unknown = new List<int>[shares];
        ThreadTeam.Each(shares, shares, share =>
        {
            (found[share], unknown[share]) = (new(), []);
            found[share].Reserve(models / shares + ScreenBounds.Count);
            var screenBounds = new ScreenBounds(camera);
            for (var i = 0; i < groups.Length; i++) groups[i].AddTo(found[share], unknown[share], grid, screenBounds, i, share, shares);
        });
        members = new(found);
        var count = members.Items.Length;
        foreach (var group in groups) group.Reserve(count);
        ThreadTeam.Shares(shares, count, (_, first, end) =>
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
        grid.Find(tile, members, order.Ranges);
        return order.Ranges.Count > 0;
    }

    /// <summary>Sorts the members that may show in a part of the picture.</summary>
    public void Sort(in PixelRect part, DepthOrder order)
    {
        grid.Find(part, members, order.Ranges);
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
        for (var i = 0; i < order.Length && !part.Hides(order[i].NearestOfRest); i++)
        {
            var index = order[i].Member;
            ref readonly var member = ref members[index];
            groups[member.Kind].Intersect(part, part.List(member), index, member.AllHitsCount);
            part.Refresh();
        }
    }
}
