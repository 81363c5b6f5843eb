using System.Buffers;
using System.Runtime.CompilerServices;

namespace RayCaster.Engine;

/// <summary>
/// Things sorted by a small number, their place; those of one place lie side by side, in the order in which they came. Their memory is rented from
/// the pool:
/// fresh pages cost more than what is written on them.
/// </summary>
internal sealed class Bins<T> where T : struct
{
    private readonly int[] starts;
    private readonly int first; // no place before it holds anything: most meshes show in a small part of a picture
    private T[] sorted;

    /// <param name="lists">What to sort; the lists are emptied.</param>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    public Bins(PooledList<(int Place, T Thing)>[] lists)
    {
        var (total, last) = (0, -1);
        first = int.MaxValue;
        foreach (var list in lists)
        {
            foreach (ref readonly var item in list.Items) (first, last) = (Math.Min(first, item.Place), Math.Max(last, item.Place));
            total += list.Count;
        }
        starts = new int[Math.Max(0, last - first + 1) + 2]; // while it is filled, place p's next free slot is at p + 1, p counted from the first
        foreach (var list in lists)
            foreach (ref readonly var item in list.Items)
                starts[item.Place - first + 2]++;
        for (var i = 2; i < starts.Length; i++) starts[i] += starts[i - 1];
        sorted = total > 0 ? ArrayPool<T>.Shared.Rent(total) : [];
        foreach (var list in lists)
        {
            foreach (ref readonly var item in list.Items) sorted[starts[item.Place - first + 1]++] = item.Thing;
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
    public ReadOnlySpan<T> this[int place]
    {
        get
        {
            var p = (long)place - first;
            return p >= 0 && p < starts.Length - 2 ? sorted.AsSpan(starts[p], starts[p + 1] - starts[p]) : [];
        }
    }
}
