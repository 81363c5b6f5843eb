using System.Buffers;
using System.Runtime.CompilerServices;

namespace RayCaster.Engine;

/// <summary>
/// Things sorted by a small number, their place; those of one place lie side by side, in the order in which they came. Their memory is rented from the pool:
/// fresh pages cost more than what is written on them.
/// </summary>
internal sealed class Bins<T> where T : struct
{
    private readonly int[] starts;
    private T[] sorted;

    /// <param name="count">How many places there are.</param>
    /// <param name="lists">What to sort; the lists are emptied.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public Bins(int count, GrowingArray<(int Place, T Thing)>[] lists)
    {
        starts = new int[count + 2]; // while it is filled, place p's next free slot is at p + 1
        var total = 0;
        foreach (var list in lists)
        {
            foreach (ref readonly var item in list.Items) starts[item.Place + 2]++;
            total += list.Count;
        }
        for (var i = 2; i < starts.Length; i++) starts[i] += starts[i - 1];
        sorted = total > 0 ? ArrayPool<T>.Shared.Rent(total) : [];
        foreach (var list in lists)
        {
            foreach (ref readonly var item in list.Items) sorted[starts[item.Place + 1]++] = item.Thing;
            list.Free();
        }
    }

    /// <summary>Gives the memory back; nothing may be asked for any more.</summary>
    public void Free()
    {
        if (sorted.Length > 0) ArrayPool<T>.Shared.Return(sorted);
        sorted = [];
    }

    /// <summary>The things of a place.</summary>
    public ReadOnlySpan<T> this[int place] => sorted.AsSpan(starts[place], starts[place + 1] - starts[place]);
}
