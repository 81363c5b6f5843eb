using System.Runtime.InteropServices;

namespace RayCaster.Engine;

/// <summary>The members of a batch that have one kind of shape.</summary>
internal abstract class BatchShapes<N> where N : struct, IPacket<N>
{
    /// <summary>Finds where the shapes show.</summary>
    /// <param name="members">Takes those that may show, with their bins in the grid.</param>
    /// <param name="others">Takes the models of which nothing is known.</param>
    public abstract void AddTo(
        PooledList<(int Bin, BatchItem Item)> members, List<int> others, ScreenBins grid, ScreenBounds bounds, int group, int share, int shares);

    /// <summary>Copies the shapes of some members into the order of the members.</summary>
    public abstract void Arrange(ReadOnlySpan<BatchItem> members, int group, int first, int end);

    public abstract void Reserve(int members);

    public abstract void Free();

    /// <summary>Intersects the packets that a part lists with a member.</summary>
    /// <param name="isClear">Whether all of its hits certainly count.</param>
    public abstract void Intersect(BatchTile<N> part, ReadOnlySpan<int> packets, int member, bool isClear);
}

internal sealed class BatchShapes<P, N>(ClipRange clip, ShapeList<P> list) : BatchShapes<N> where P : struct, IPrimitive where N : struct, IPacket<N>
{
    private readonly PooledList<(P Shape, int Model)> arranged = new();

    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    public override void AddTo(
        PooledList<(int Bin, BatchItem Item)> members, List<int> others, ScreenBins grid, ScreenBounds bounds, int group, int share, int shares)
    {
        var all = CollectionsMarshal.AsSpan(list.Items);
        var (begin, end) = ((int)((long)all.Length * share / shares), (int)((long)all.Length * (share + 1) / shares));
        for (var first = begin; first < end; first += ScreenBounds.Count)
        {
            var count = Math.Min(ScreenBounds.Count, end - first);
            Project(all.Slice(first, count), bounds);
            for (var i = 0; i < count; i++)
            {
                if (bounds.Read(i, out var nearest, out var isClear) is not { } tile) others.Add(all[first + i].Model);
                else if (tile is { Width: > 0, Height: > 0 })
                    members.Add((grid.BinOf(tile), new() { ShowsIn = tile, Nearest = nearest, Kind = group, Index = first + i, IsClear = isClear }));
            }
        }
    }

    private static void Project(ReadOnlySpan<(P Shape, int Model)> some, ScreenBounds screenBounds)
    {
        if (default(P) is IBoundingSphere)
        {
            Span<(Vector3 Center, double Radius)> balls = stackalloc (Vector3, double)[some.Length];
            for (var i = 0; i < some.Length; i++) balls[i] = (((IBoundingSphere)some[i].Shape).Center, ((IBoundingSphere)some[i].Shape).Radius);
            screenBounds.Project<N>(balls);
        }
        else
        {
            Span<Bounds> boxes = stackalloc Bounds[some.Length];
            for (var i = 0; i < some.Length; i++) boxes[i] = ((IBounded)some[i].Shape).Bounds;
            screenBounds.Project<N>(boxes);
        }
    }

    public override void Reserve(int members) => arranged.Resize(members);

    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    public override void Arrange(ReadOnlySpan<BatchItem> members, int group, int first, int end)
    {
        var from = CollectionsMarshal.AsSpan(list.Items);
        var to = arranged.Items;
        for (var i = first; i < end; i++)
            if (members[i].Kind == group)
                to[i] = from[members[i].Index];
    }

    public override void Free() => arranged.Free();

    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    public override void Intersect(BatchTile<N> part, ReadOnlySpan<int> packets, int member, bool isClear)
    {
        var range = clip;
        var rays = part.Rays;
        var (shape, model) = arranged.Items[member];
        foreach (var at in packets)
        {
            var crossings = shape.Intersect(rays.RaysAt<N>(at));
            // Testing which crossings count costs about as much as the formula of a sphere.
            var hit = isClear ? N.IfNaN(crossings.Near, crossings.Far) : range.First(crossings, rays.DepthPerTAt<N>(at));
            rays.MergeNearest(at, hit, Lanes.Broadcast<N>(model));
        }
    }
}
