using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace RayCaster;

/// <summary>The members of a crowd that have one kind of shape.</summary>
internal abstract class CrowdGroup
{
    /// <summary>Finds where the shapes show.</summary>
    /// <param name="outlines">The tool for it.</param>
    /// <param name="group">The number of this group.</param>
    /// <param name="members">Takes those that may show.</param>
    /// <param name="others">Takes the models of which nothing is known.</param>
    public abstract void AddTo(GrowingArray<CrowdMember> members, List<int> others, Outlines outlines, int group);

    /// <summary>Lets the rays of a part meet the shapes, the nearest first.</summary>
    /// <param name="part">The part.</param>
    /// <param name="members">All members of the crowd.</param>
    /// <param name="order">Those that may show in the part.</param>
    /// <param name="next">Where in this order to begin.</param>
    /// <returns>Where the next group's member comes; the end of the order where all that follow are hidden.</returns>
    public abstract int Meet(CrowdPart part, CrowdMember[] members, ReadOnlySpan<int> order, int next);
}

/// <inheritdoc/>
/// <typeparam name="P">The kind of shape.</typeparam>
internal sealed class CrowdGroup<P>(ClipRange clip) : CrowdGroup where P : struct, IPrimitive
{
    private readonly GrowingArray<(P Shape, int Model)> shapes = new();

    /// <summary>Adds a shape and the place of its model in the scene.</summary>
    public void Add(in P shape, int model) => shapes.Add((shape, model));

    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public override void AddTo(GrowingArray<CrowdMember> members, List<int> others, Outlines outlines, int group)
    {
        var all = shapes.Items;
        var member = new CrowdMember { Group = group };
        for (var first = 0; first < all.Length; first += Outlines.Count)
        {
            var count = Math.Min(Outlines.Count, all.Length - first);
            for (var i = 0; i < count; i++)
            {
                ref readonly var shape = ref all[first + i].Shape;
                if (shape is IRound)
                {
                    var center = ((IRound)shape).Center;
                    (outlines.X[i], outlines.Y[i], outlines.Z[i], outlines.Radius[i]) = (center.X, center.Y, center.Z, ((IRound)shape).Radius);
                }
                else
                {
                    var bounds = ((IBounded)shape).Bounds;
                    var (center, half) = (0.5 * (bounds.Min + bounds.Max), 0.5 * (bounds.Max - bounds.Min));
                    (outlines.X[i], outlines.Y[i], outlines.Z[i]) = (center.X, center.Y, center.Z);
                    (outlines.HalfX[i], outlines.HalfY[i], outlines.HalfZ[i]) = (half.X, half.Y, half.Z);
                }
            }
            if (Vector512.IsHardwareAccelerated) Look<WidePacket>(outlines);
            else Look<Packet>(outlines);
            for (var i = 0; i < count; i++)
            {
                member.Place = first + i;
                var shows = outlines.Read(i, ref member);
                if (shows == true) members.Add(member);
                else if (shows is null) others.Add(all[first + i].Model);
            }
        }
    }

    private static void Look<N>(Outlines outlines) where N : struct, IPacket<N>
    {
        if (typeof(P).IsAssignableTo(typeof(IRound))) outlines.OfBalls<N>();
        else outlines.OfBoxes<N>();
    }

    /// <inheritdoc/>
    public override int Meet(CrowdPart part, CrowdMember[] members, ReadOnlySpan<int> order, int next) => Vector512.IsHardwareAccelerated
        ? Meet<WidePacket>(part, members, order, next)
        : Meet<Packet>(part, members, order, next);

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private int Meet<N>(CrowdPart part, CrowdMember[] members, ReadOnlySpan<int> order, int next) where N : struct, IPacket<N>
    {
        var all = shapes.Items;
        var rows = part.Rows;
        var tile = part.Tile;
        var group = members[order[next]].Group;
        for (; next < order.Length; next++)
        {
            ref readonly var member = ref members[order[next]];
            if (member.Group != group) return next;
            if (part.Hides<N>(member.NearestOfRest)) return order.Length;
            var nearest = RaySpan.All<N>(member.Nearest);
            var (first, end) = (Math.Max(member.Left - tile.Column, 0) / N.Count * N.Count, Math.Min(member.Right, tile.EndColumn) - tile.Column);
            var (row, endRow) = (Math.Max(member.Bottom - tile.Row, 0), Math.Min(member.Top, tile.EndRow) - tile.Row);
            ref readonly var it = ref all[member.Place];
            var shape = it.Shape; // a local, so that its constants stay in registers
            if (end - first > tile.Width / 2 && endRow - row > tile.Height / 2 && part.Hides(clip.First(shape.Cross(part.Rays.Rays), part.Rays.ZPerT))) continue;
            for (; row < endRow; row++)
            {
                var span = rows[row];
                for (var i = first; i < end; i += N.Count)
                {
                    if (N.All(span.NearestAt<N>(i) < nearest)) continue; // hidden
                    span.Keep(i, span.First(i, shape.Cross(span.RaysAt<N>(i))), it.Model);
                }
            }
        }
        return next;
    }
}
