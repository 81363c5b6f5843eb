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

    /// <summary>Puts the shapes into the order of the members.</summary>
    public abstract void Arrange(CrowdMember[] members, int group);

    /// <summary>Lets the rays of a part meet the shapes, the nearest first.</summary>
    /// <param name="part">The part.</param>
    /// <param name="members">All members of the crowd.</param>
    /// <param name="order">Those that may show in the part; the first is one of this group.</param>
    /// <returns>The rest of the order, from the next group's member on; nothing where all that follow are hidden.</returns>
    public abstract ReadOnlySpan<(int Member, float NearestOfRest)> Meet(
        CrowdPart part, CrowdMember[] members, ReadOnlySpan<(int Member, float NearestOfRest)> order);
}

/// <inheritdoc/>
/// <typeparam name="P">The kind of shape.</typeparam>
internal sealed class CrowdGroup<P> : CrowdGroup where P : struct, IPrimitive
{
    private readonly ClipRange clip;
    private readonly GrowingArray<(P Shape, int Model)> shapes = new(); // as they came
    private (P Shape, int Model)[] arranged = [];

    /// <param name="clip">Which hits count.</param>
    /// <param name="most">There are not more shapes than this.</param>
    public CrowdGroup(ClipRange clip, int most)
    {
        this.clip = clip;
        shapes.Reserve(most);
    }

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
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public override void Arrange(CrowdMember[] members, int group)
    {
        var all = shapes.Items;
        arranged = GC.AllocateUninitializedArray<(P, int)>(all.Length);
        var count = 0;
        foreach (ref var member in members.AsSpan())
        {
            if (member.Group != group) continue;
            arranged[count] = all[member.Place];
            member.Place = count++;
        }
        shapes.Free();
    }

    /// <inheritdoc/>
    public override ReadOnlySpan<(int Member, float NearestOfRest)> Meet(
        CrowdPart part, CrowdMember[] members, ReadOnlySpan<(int Member, float NearestOfRest)> order) => Vector512.IsHardwareAccelerated
        ? Meet<WidePacket>(part, members, order)
        : Meet<Packet>(part, members, order);

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private ReadOnlySpan<(int Member, float NearestOfRest)> Meet<N>(
        CrowdPart part, CrowdMember[] members, ReadOnlySpan<(int Member, float NearestOfRest)> order) where N : struct, IPacket<N>
    {
        var group = members[order[0].Member].Group;
        for (var i = 0; i < order.Length; i++)
        {
            ref readonly var member = ref members[order[i].Member];
            if (member.Group != group) return order[i..];
            if (part.Hides<N>(order[i].NearestOfRest)) return default;
            ref readonly var it = ref arranged[member.Place];
            if (part.IsMostlyCoveredBy(member) && part.Hides(Range(it.Shape, part.AllRays))) continue;
            var packets = part.PacketsOf<N>(member);
            if (packets.Length > 0) Meet<N>(it.Shape, it.Model, part, packets);
        }
        return default;
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization | MethodImplOptions.NoInlining)]
    private void Meet<N>(P shape, int model, CrowdPart part, ReadOnlySpan<int> packets) where N : struct, IPacket<N>
    {
        var (range, rays, hits) = (clip, part.Rays, part.Hits); // locals, as the shape is, so that their constants stay in registers
        var index = RaySpan.All<N>(model);
        foreach (var i in packets) hits.Keep(i, range.First(shape.Cross(rays.At<N>(i)), rays.ZPerTAt<N>(i)), index);
    }

    /// <summary>Where all hits in a part lie.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)] // its many numbers would crowd out those of the loop
    private Interval Range(in P shape, TileRays rays) => clip.First(shape.Cross(rays.Rays), rays.ZPerT);
}
