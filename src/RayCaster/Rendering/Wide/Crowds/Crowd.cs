using System.Runtime.CompilerServices;

namespace RayCaster;

/// <summary>
/// Many models with bounds, as a camera sees them: found by their rectangles in the picture, the nearest first, so that each hides most of
/// those behind it before their formula is asked.
/// </summary>
internal sealed class Crowd(Camera camera)
{
    /// <summary>A member in more parts than this is looked at in all of them, so that a million large ones do not need a place in each.</summary>
    private const int ManyParts = 64;

    /// <summary>So many classes of distance are told apart; within one the order does not matter.</summary>
    private const int MostClasses = 1 << 14;

    private readonly List<CrowdGroup> groups = [];
    private readonly int partsAcross = PartsOf(camera.Width), partsUp = PartsOf(camera.Height);
    private CrowdMember[] members = [];  // the nearest first
    private int[] starts = [], listed = []; // of part i the members listed[starts[i]] … listed[starts[i + 1] − 1]
    private readonly GrowingArray<int> large = new(); // those in many parts

    private static int PartsOf(int pixels) => (pixels + CrowdPart.Side - 1) / CrowdPart.Side;

    /// <summary>Takes a shape, if it has bounds.</summary>
    /// <param name="shape">The shape.</param>
    /// <param name="model">The place of its model in the scene.</param>
    public bool Add<P>(in P shape, int model) where P : struct, IPrimitive
    {
        if (shape is not IBounded) return false;
        var group = groups.Count > 0 ? groups[^1] as CrowdGroup<P> : null;
        (group ?? GroupOf<P>()).Add(shape, model);
        return true;
    }

    private CrowdGroup<P> GroupOf<P>() where P : struct, IPrimitive
    {
        foreach (var group in groups)
            if (group is CrowdGroup<P> same)
                return same;
        var created = new CrowdGroup<P>(camera.ClipRange);
        groups.Add(created);
        return created;
    }

    /// <summary>Sorts all that has been added by distance and place.</summary>
    /// <returns>The models of which nothing can be said in advance: they reach to the eye's plane.</returns>
    public List<int> Sort()
    {
        var others = new List<int>();
        var found = new GrowingArray<CrowdMember>();
        var outlines = new Outlines(camera);
        for (var i = 0; i < groups.Count; i++) groups[i].AddTo(found, others, outlines, i);
        SortByDistance(found.Items);
        found.Free();
        SortByPlace();
        return others;
    }

    /// <summary>Whether there may be any members in a tile.</summary>
    public bool Shows(in Tile tile)
    {
        if (large.Count > 0) return true;
        var (x0, x1) = (tile.Column / CrowdPart.Side, (tile.EndColumn - 1) / CrowdPart.Side);
        for (var y = tile.Row / CrowdPart.Side; y <= (tile.EndRow - 1) / CrowdPart.Side; y++)
            if (starts[y * partsAcross + x0] < starts[y * partsAcross + x1 + 1])
                return true;
        return false;
    }

    /// <summary>The members that may show in a part of the picture, the nearest first.</summary>
    /// <param name="part">A part that does not cross a multiple of <see cref="CrowdPart.Side"/>.</param>
    /// <param name="merged">Room for them.</param>
    public ReadOnlySpan<int> MembersOf(in Tile part, GrowingArray<int> merged)
    {
        var i = part.Row / CrowdPart.Side * partsAcross + part.Column / CrowdPart.Side;
        var own = listed.AsSpan(starts[i]..starts[i + 1]);
        if (large.Count == 0) return own;
        merged.Clear();
        var next = 0;
        foreach (var other in large.Items)
        {
            ref readonly var member = ref members[other];
            if (member.Left >= part.EndColumn || member.Right <= part.Column || member.Bottom >= part.EndRow || member.Top <= part.Row) continue;
            while (next < own.Length && own[next] < other) merged.Add(own[next++]);
            merged.Add(other);
        }
        while (next < own.Length) merged.Add(own[next++]);
        return merged.Items;
    }

    /// <summary>Lets the rays of a part meet members.</summary>
    public void Meet(CrowdPart part, ReadOnlySpan<int> order)
    {
        for (var next = 0; next < order.Length;) next = groups[members[order[next]].Group].Meet(part, members, order, next);
    }

    /// <summary>By the bits of their least distances, which for floats that are not negative grow with the number.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void SortByDistance(Span<CrowdMember> found)
    {
        var (least, most) = (int.MaxValue, 0);
        foreach (ref var member in found)
        {
            var bits = BitConverter.SingleToInt32Bits(member.Nearest);
            (least, most) = (Math.Min(least, bits), Math.Max(most, bits));
        }
        var shift = 0;
        while ((most - least) >> shift >= MostClasses) shift++;
        var next = new int[MostClasses + 1];
        foreach (ref var member in found) next[((BitConverter.SingleToInt32Bits(member.Nearest) - least) >> shift) + 1]++;
        for (var i = 1; i < next.Length; i++) next[i] += next[i - 1];
        members = GC.AllocateUninitializedArray<CrowdMember>(found.Length);
        foreach (ref var member in found)
        {
            var distance = (BitConverter.SingleToInt32Bits(member.Nearest) - least) >> shift;
            member.NearestOfRest = BitConverter.Int32BitsToSingle((distance << shift) + least);
            members[next[distance]++] = member;
        }
    }

    /// <summary>Counts first, then places: all lists in one array.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void SortByPlace()
    {
        starts = new int[partsAcross * partsUp + 2]; // while it is filled, part p's next free slot is at p + 1
        for (var i = 0; i < members.Length; i++)
        {
            var (x0, x1, y0, y1) = PartsOf(members[i]);
            if ((long)(x1 - x0 + 1) * (y1 - y0 + 1) > ManyParts)
            {
                large.Add(i);
                continue;
            }
            for (var y = y0; y <= y1; y++)
                for (var x = x0; x <= x1; x++)
                    starts[y * partsAcross + x + 2]++;
        }
        for (var i = 2; i < starts.Length; i++) starts[i] += starts[i - 1];
        listed = GC.AllocateUninitializedArray<int>(starts[^1]);
        for (var i = 0; i < members.Length; i++)
        {
            var (x0, x1, y0, y1) = PartsOf(members[i]);
            if ((long)(x1 - x0 + 1) * (y1 - y0 + 1) > ManyParts) continue;
            for (var y = y0; y <= y1; y++)
                for (var x = x0; x <= x1; x++)
                    listed[starts[y * partsAcross + x + 1]++] = i;
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static (int X0, int X1, int Y0, int Y1) PartsOf(in CrowdMember member) =>
        (member.Left / CrowdPart.Side, (member.Right - 1) / CrowdPart.Side, member.Bottom / CrowdPart.Side, (member.Top - 1) / CrowdPart.Side);
}
