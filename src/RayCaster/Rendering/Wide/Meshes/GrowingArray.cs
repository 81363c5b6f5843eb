using System.Runtime.CompilerServices;

namespace RayCaster;

/// <summary>A list whose items can be read as a span.</summary>
internal sealed class GrowingArray<T>
{
    private T[] items = [];
    private int count;

    /// <summary>How many there are.</summary>
    public int Count => count;

    /// <summary>All of them.</summary>
    public Span<T> Items => items.AsSpan(0, count);

    /// <summary>Adds one at the end.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Add(T item)
    {
        if (count == items.Length) Array.Resize(ref items, Math.Max(1024, 2 * count));
        items[count++] = item;
    }

    /// <summary>Removes all and gives the memory back.</summary>
    public void Clear() => (items, count) = ([], 0);

    /// <summary>Removes all but the first ones.</summary>
    public void Keep(int first) => count = first;
}
