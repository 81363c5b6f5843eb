namespace RayCaster.Engine;

/// <summary>What depends only on the models of a scene: the shapes that have bounds, a list for each kind.</summary>
internal sealed class ShapeLists : IShapeVisitor
{
    private static readonly ConditionalWeakTable<IReadOnlyList<Model>, ShapeLists> kept = [];

    private readonly List<ShapeList> lists = [];
    private readonly List<int> others = [];
    private int count;

    public IReadOnlyList<ShapeList> Lists => lists;

    /// <summary>The indices of all other models.</summary>
    public IReadOnlyList<int> Others => others;

    /// <summary>The shapes of a scene's models.</summary>
    /// <param name="isKept">Whether the lists stay in memory as long as the list of models does, for the next picture.</param>
    public static ShapeLists Of(IReadOnlyList<Model> models, bool isKept, int threads)
    {
        if (isKept && kept.TryGetValue(models, out var known) && known.count == models.Count) return known;
        var shares = ThreadTeam.SharesOf(models.Count, threads);
        var parts = new ShapeLists[shares];
        ThreadTeam.Shares(shares, models.Count, (share, first, end) =>
        {
            parts[share] = new();
            for (var index = first; index < end; index++) parts[share].Add(models[index], index);
        });
        for (var share = 1; share < shares; share++) parts[0].Append(parts[share]);
        parts[0].count = models.Count;
        if (isKept) kept.AddOrUpdate(models, parts[0]);
        return parts[0];
    }

    /// <summary>Adds an empty list for a kind of shape; false for those without bounds.</summary>
    public bool Visit<P>(P shape) where P : struct, IPrimitive
    {
        if (shape is not IBounded) return false;
        lists.Add(new ShapeList<P>());
        return true;
    }

    private void Add(Model model, int index)
    {
        for (var i = lists.Count - 1; i >= 0; i--)
            if (lists[i].Add(model, index))
                return;
        if (model.Accept(this)) lists[^1].Add(model, index);
        else others.Add(index);
    }

    private void Append(ShapeLists more)
    {
        foreach (var list in more.lists)
            if (!lists.Exists(known => known.Append(list)))
                lists.Add(list);
        others.AddRange(more.others);
    }
}

/// <summary>Shapes of one kind, and the indices of their models.</summary>
internal abstract class ShapeList
{
    public abstract bool Add(Model model, int index);

    /// <summary>Adds all shapes of another list if they are of this kind.</summary>
    public abstract bool Append(ShapeList list);

    public abstract BatchShapes<N> ForBatch<N>(ClipRange clip) where N : struct, IPacket<N>;
}

internal sealed class ShapeList<P> : ShapeList where P : struct, IPrimitive
{
    public List<(P Shape, int Model)> Items { get; } = [];

    public override bool Add(Model model, int index)
    {
        if (model is not Model<P> { Primitive: var shape }) return false;
        Items.Add((shape, index));
        return true;
    }

    public override bool Append(ShapeList list)
    {
        if (list is not ShapeList<P> same) return false;
        Items.AddRange(same.Items);
        return true;
    }

    public override BatchShapes<N> ForBatch<N>(ClipRange clip) => new BatchShapes<P, N>(clip, this);
}
