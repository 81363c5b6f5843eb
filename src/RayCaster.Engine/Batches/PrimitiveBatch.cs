using System.Runtime.CompilerServices;

namespace RayCaster.Engine;

/// <summary>
/// Many models with bounds, as a camera sees them: found by their rectangles in the picture, the nearest first, so that each hides most of
/// those behind it before their formula is asked.
/// </summary>
/// <typeparam name="N">The kind of packet to compute with.</typeparam>
internal sealed class PrimitiveBatch<N>(Camera camera, int mostMembers) : IModelVisitor where N : struct, IPacket<N>
{
    private const int Batch = DepthOrder.Batch;

    /// <summary>With fewer models than this for each thread, one thread is ready before the others have begun.</summary>
    private const int LeastShare = 8192;

    private readonly List<BatchShapes<N>> groups = [];
    private readonly ScreenBins grid = new(camera);
    private readonly PooledList<BatchItem> members = new(); // in the order of the grid's cells

    /// <summary>Takes a model, if its shape has bounds.</summary>
    /// <param name="model">The model.</param>
    /// <param name="place">Its place in the scene.</param>
    public bool Add(Model model, int place)
    {
        for (var i = groups.Count - 1; i >= 0; i--)
            if (groups[i].Add(model, place))
                return true;
        var before = groups.Count;
        model.Accept(this); // once for each kind of shape: the group that it makes takes the others
        return groups.Count > before && groups[^1].Add(model, place);
    }

    void IModelVisitor.Visit<P>(Model<P> model)
    {
        if (model.Primitive is IBounded) groups.Add(new BatchShapes<P, N>(camera.ClipRange, mostMembers));
    }

    void IModelVisitor.Visit(Mesh mesh)
    {
    }

    void IModelVisitor.VisitOther(Model model)
    {
    }

    /// <summary>Finds where in the picture all that has been added may show.</summary>
    /// <param name="threads">How many threads may do so.</param>
    /// <returns>The models of which nothing can be said in advance: they reach to the eye's plane.</returns>
    public List<int> Arrange(int threads)
    {
        var shares = mostMembers / LeastShare >= threads ? threads : 1;
        var (found, unknown) = (new PooledList<BatchItem>[shares], new List<int>[shares]);
        ThreadTeam.Each(shares, shares, share =>
        {
            (found[share], unknown[share]) = (new(), []);
            found[share].Reserve(mostMembers / shares + ScreenBounds.Count);
            var outlines = new ScreenBounds(camera);
            for (var i = 0; i < groups.Count; i++) groups[i].AddTo(found[share], unknown[share], outlines, i, share, shares);
        });
        grid.Sort(found, members);
        foreach (var some in found) some.Free();
        for (var i = 0; i < groups.Count; i++) groups[i].Arrange(members.Items, i);
        return [.. unknown.SelectMany(some => some)];
    }

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
                ref readonly var member = ref members[order[i].Member];
                groups[member.Kind].Fetch(member.Place);
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
                end = part.List(member);
            }
            groups[group].Meet(part, first, end, isClear);
            part.Refresh();
        }
    }
}
