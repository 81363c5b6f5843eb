using System.Buffers;

namespace RayCaster.Engine;

/// <summary>Items sorted by a small number, their bin; items of one bin keep their order. The memory is rented from the pool: fresh pages cost
/// more than writing to them.</summary>
internal sealed class Bins<T> where T : struct
{
    private readonly int[] starts; // the first position of each bin, and the number of items as the last
    private readonly int first;    // the first bin that holds anything: most meshes show in a small part of a picture
    private readonly T[] sorted;

    /// <param name="lists">What to sort; the lists are emptied.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public Bins(PooledList<(int Bin, T Item)>[] lists)
    {
        var (first, last, total) = (int.MaxValue, -1, 0);
        foreach (var list in lists)
        {
            total += list.Count;
            foreach (ref readonly var item in list.Items) (first, last) = (Math.Min(first, item.Bin), Math.Max(last, item.Bin));
        }
        var next = new int[total > 0 ? last - first + 2 : 1];
        var to = ArrayPool<T>.Shared.Rent(total);
        (this.first, starts, sorted) = (first, next, to);
        foreach (var list in lists)
            foreach (ref readonly var item in list.Items)
                next[item.Bin - first]++;
        for (var bin = 1; bin < next.Length; bin++) next[bin] += next[bin - 1];
        for (var i = lists.Length - 1; i >= 0; i--) // a bin is filled from its end to its start
        {
            var items = lists[i].Items;
            for (var k = items.Length - 1; k >= 0; k--) to[--next[items[k].Bin - first]] = items[k].Item;
            lists[i].Free();
        }
    }

    public Span<T> Items => sorted.AsSpan(0, starts[^1]);

    public ReadOnlySpan<T> this[int bin] => Items[StartOf(bin)..StartOf(bin + 1)];

    /// <summary>How many items lie in the bins before this one.</summary>
    public int StartOf(int bin) => starts[Math.Clamp((long)bin - first, 0, starts.Length - 1)];

    /// <summary>Returns the memory; the object cannot be used any more.</summary>
    public void Free() => ArrayPool<T>.Shared.Return(sorted);
}
