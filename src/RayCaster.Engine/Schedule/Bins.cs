using System.Buffers;

namespace RayCaster.Engine;

/// <summary>Items sorted by a small number, their bin; items of one bin keep their order. The memory is rented from the pool: fresh pages cost
/// more than writing to them.</summary>
internal sealed class Bins<T> where T : struct
{
    private readonly int[] starts;
    private readonly int first; // the first bin that holds anything: most meshes show in a small part of a picture
    private T[] sorted;

    /// <param name="lists">What to sort, each list on a thread; the lists are emptied.</param>
    public Bins(PooledList<(int Bin, T Item)>[] lists)
    {
        var ranges = new (int First, int Last)[lists.Length];
        ThreadTeam.Each(lists.Length, lists.Length, list => ranges[list] = RangeOf(lists[list].Items));
        first = ranges.Length > 0 ? ranges.Min(range => range.First) : 0;
        var bins = ranges.Length > 0 ? Math.Max(0, ranges.Max(range => range.Last) - first + 1) : 0;
        var total = lists.Sum(list => list.Count);
        sorted = total > 0 ? ArrayPool<T>.Shared.Rent(total) : [];
        starts = CountingSort.Sort(
            lists.Length, bins, (list, counts) => Count(lists[list].Items, counts), (list, next) => Put(lists[list].Items, next));
        foreach (var list in lists) list.Free();
    }

    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private static (int First, int Last) RangeOf(ReadOnlySpan<(int Bin, T Item)> items)
    {
        var (least, most) = (int.MaxValue, -1);
        foreach (ref readonly var item in items) (least, most) = (Math.Min(least, item.Bin), Math.Max(most, item.Bin));
        return (least, most);
    }

    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private void Count(ReadOnlySpan<(int Bin, T Item)> items, int[] counts)
    {
        foreach (ref readonly var item in items) counts[item.Bin - first]++;
    }

    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private void Put(ReadOnlySpan<(int Bin, T Item)> items, int[] next)
    {
        var to = sorted;
        foreach (ref readonly var item in items) to[next[item.Bin - first]++] = item.Item;
    }

    /// <summary>Returns the memory; the object cannot be used any more.</summary>
    public void Free()
    {
        if (sorted.Length > 0) ArrayPool<T>.Shared.Return(sorted);
        sorted = [];
    }

    public ReadOnlySpan<T> this[int bin]
    {
        get
        {
            var p = (long)bin - first;
            return p >= 0 && p < starts.Length - 1 ? sorted.AsSpan(starts[p], starts[p + 1] - starts[p]) : [];
        }
    }
}
