using System.Runtime.InteropServices;

namespace RayCaster.Engine;

/// <summary>Numbers in an array without range checks, for loops in which the checks would take most of the time. docs/limits.md says for each use
/// why no position lies outside. A debug build checks all positions.</summary>
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
internal readonly ref struct RawSpan<T>(ReadOnlySpan<T> items) where T : struct
{
    private readonly ref T first = ref MemoryMarshal.GetReference(items);
#if DEBUG
    private readonly int length = items.Length;
#endif

    public ref T this[int place]
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => ref From(place, 1);
    }

    /// <summary>The numbers from a position on, as many as fill 16 bytes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector128<T> Load128(int place) => Vector128.LoadUnsafe(ref From(place, Vector128<T>.Count));

    /// <summary>The eight numbers from a place on, or as many as fill 32 bytes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector256<T> Load256(int place) => Vector256.LoadUnsafe(ref From(place, Vector256<T>.Count));

    /// <summary>Writes numbers.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Store(Vector256<T> numbers, int place) => numbers.StoreUnsafe(ref From(place, Vector256<T>.Count));

    /// <inheritdoc cref="Store(Vector256{T}, int)"/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Store(Vector512<T> numbers, int place) => numbers.StoreUnsafe(ref From(place, Vector512<T>.Count));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private ref T From(int place, int count)
    {
#if DEBUG
        if (place < 0 || place > length - count) throw new IndexOutOfRangeException($"{count} numbers from {place} on, of {length}");
#endif
        return ref Unsafe.Add(ref first, place);
    }
}

/// <summary>Makes a <see cref="RawSpan{T}"/> of other things.</summary>
internal static class RawSpan
{
    /// <summary>The coordinates of points, three for each.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static RawSpan<double> NumbersOf(Vector3[] points) =>
        new(MemoryMarshal.CreateReadOnlySpan(ref Unsafe.As<Vector3, double>(ref MemoryMarshal.GetArrayDataReference(points)), 3 * points.Length));
}
