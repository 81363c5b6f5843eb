namespace RayCaster.Engine;

/// <summary>Sorts the members of a part, the nearest first; each thread has its own.</summary>
internal sealed class DepthOrder
{
    /// <summary>The number of classes of distance; within a class the order does not matter.</summary>
    private const int Classes = 256;

    private readonly int[] next = new int[Classes + 1];
    private (int Member, int Distance)[] listed = [];
    private (int Member, float NearestOfRest)[] sorted = [];
    private int count;

    /// <summary>The index of each member, and the least distance of it and all that follow.</summary>
    public ReadOnlySpan<(int Member, float NearestOfRest)> Sorted => sorted.AsSpan(0, count);

    /// <summary>The ranges of members to look through.</summary>
    public PooledList<(int First, int End)> Ranges { get; } = new();

    /// <summary>Sorts those members of the ranges that may show in a part.</summary>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    public void Sort(ReadOnlySpan<BatchItem> members, in PixelRect part)
    {
        count = 0;
        foreach (var (first, end) in Ranges.Items) Add(members, first, end, part);
        if (count > 0) Sort();
    }

    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private void Add(ReadOnlySpan<BatchItem> members, int first, int end, in PixelRect part)
    {
        if (listed.Length < count + end - first)
        {
            Array.Resize(ref listed, 2 * (count + end - first));
            sorted = new (int, float)[listed.Length];
        }
        var n = count;
        for (var i = first; i < end; i++)
        {
            ref readonly var member = ref members[i];
            listed[n] = (i, BitConverter.SingleToInt32Bits(member.Nearest));
            n += part.Overlaps(member.ShowsIn) ? 1 : 0;
        }
        count = n;
    }

    /// <summary>Sorts by the bits of the least distances; those of floats that are not negative grow with the number.</summary>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private void Sort()
    {
        var listed = this.listed.AsSpan(0, count);
        var (least, most) = (int.MaxValue, 0);
        foreach (var (_, distance) in listed) (least, most) = (Math.Min(least, distance), Math.Max(most, distance));
        var shift = 0;
        while ((most - least) >> shift >= Classes) shift++;

        Array.Clear(next);
        foreach (var (_, distance) in listed) next[((distance - least) >> shift) + 1]++;
        for (var i = 1; i < next.Length; i++) next[i] += next[i - 1];
        foreach (var (member, bits) in listed)
        {
            var distance = (bits - least) >> shift;
            sorted[next[distance]++] = (member, BitConverter.Int32BitsToSingle((distance << shift) + least));
        }
    }
}
