using System.Runtime.InteropServices;

namespace RayCaster.Engine;

/// <summary>Numbers in an array without range checks, for loops in which the checks would take most of the time. docs/limits.md says for each use
/// why no position lies outside. A debug build checks all positions.</summary>
internal readonly ref struct RawSpan<T> where T : struct
{
    private readonly ref T first;
#if DEBUG
    private readonly nint length;
#endif

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public RawSpan(ReadOnlySpan<T> items) : this(ref MemoryMarshal.GetReference(items), items.Length) { }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public RawSpan(ref T first, nint length)
    {
        this.first = ref first;
#if DEBUG
        this.length = length;
#endif
    }

    public ref T this[nint index]
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => ref From(index, 1);
    }

    /// <summary>The numbers from a position on, as many as fill 16 bytes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector128<T> Load128(nint index) => Vector128.LoadUnsafe(ref From(index, Vector128<T>.Count));

    /// <summary>The eight numbers from an index on, or as many as fill 32 bytes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector256<T> Load256(nint index) => Vector256.LoadUnsafe(ref From(index, Vector256<T>.Count));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Store(Vector256<T> numbers, nint index) => numbers.StoreUnsafe(ref From(index, Vector256<T>.Count));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Store(Vector512<T> numbers, nint index) => numbers.StoreUnsafe(ref From(index, Vector512<T>.Count));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private ref T From(nint index, int count)
    {
#if DEBUG
        if (index < 0 || index > length - count) throw new IndexOutOfRangeException($"{count} numbers from {index} on, of {length}");
#endif
        return ref Unsafe.Add(ref first, index);
    }
}

internal static class RawSpan
{
    /// <summary>The coordinates of points, three for each.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static RawSpan<double> NumbersOf(Vector3[] points) =>
        new(ref Unsafe.As<Vector3, double>(ref MemoryMarshal.GetArrayDataReference(points)), (nint)3 * points.Length);
}
