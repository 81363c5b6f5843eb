using System.Buffers;

namespace RayCaster.Engine;

/// <summary>A list of plain values that can be read as a span. The memory is rented from the pool: fresh pages cost more than writing to
/// them.</summary>
internal sealed class PooledList<T> where T : struct
{
    private const int MinLength = 1024;

    private T[] items = [];
    private int count;

    public int Count => count;

    public Span<T> Items => items.AsSpan(0, count);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Add(T item)
    {
        if (count == items.Length) Grow();
        items[count++] = item;
    }

    /// <summary>Changes the number of items; new ones are not initialised.</summary>
    public void Resize(int length)
    {
        Reserve(length);
        count = length;
    }

    /// <summary>Makes room for this many items, so that they are not copied while it grows.</summary>
    public void Reserve(int capacity)
    {
        if (capacity > items.Length) Move(capacity);
    }

    public void Clear() => count = 0;

    public void Free()
    {
        if (items.Length > 0) ArrayPool<T>.Shared.Return(items);
        (items, count) = ([], 0);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private void Grow() => Move(Math.Max(MinLength, 2 * count));

    private void Move(int capacity)
    {
        var larger = ArrayPool<T>.Shared.Rent(capacity);
        Items.CopyTo(larger);
        if (items.Length > 0) ArrayPool<T>.Shared.Return(items);
        items = larger;
    }
}
