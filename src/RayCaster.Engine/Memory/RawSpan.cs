using System.Diagnostics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace RayCaster.Engine;

/// <summary>Numbers in an array without range checks, for loops in which the checks would take most of the time. docs/limits.md says for each use
/// why no position lies outside. With the constant CHECKED all positions are checked.</summary>
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
internal readonly ref struct RawSpan<T>(ReadOnlySpan<T> items) where T : struct
{
    private readonly ref T first = ref MemoryMarshal.GetReference(items);
#if CHECKED
    private readonly int length = items.Length;
#endif

    public ref T this[int place]
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get
        {
            Check(place, 1);
            return ref Unsafe.Add(ref first, place);
        }
    }

    /// <summary>The numbers from a position on, as many as fill 16 bytes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector128<T> Load128(int place)
    {
        Check(place, Vector128<T>.Count);
        return Vector128.LoadUnsafe(ref Unsafe.Add(ref first, place));
    }

    /// <summary>The eight numbers from a place on, or as many as fill 32 bytes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector256<T> Load256(int place)
    {
        Check(place, Vector256<T>.Count);
        return Vector256.LoadUnsafe(ref Unsafe.Add(ref first, place));
    }

    /// <summary>Writes numbers.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Store(Vector256<T> numbers, int place)
    {
        Check(place, Vector256<T>.Count);
        numbers.StoreUnsafe(ref Unsafe.Add(ref first, place));
    }

    /// <inheritdoc cref="Store(Vector256{T}, int)"/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Store(Vector512<T> numbers, int place)
    {
        Check(place, Vector512<T>.Count);
        numbers.StoreUnsafe(ref Unsafe.Add(ref first, place));
    }

    [Conditional("CHECKED")]
    private void Check(int place, int count)
    {
#if CHECKED
        if (place < 0 || place > length - count) throw new IndexOutOfRangeException($"{count} numbers from {place} on, of {length}");
#endif
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
