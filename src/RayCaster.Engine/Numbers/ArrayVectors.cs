namespace RayCaster.Engine;

/// <summary>Vectors of consecutive numbers in an array. Only the first position is checked: the arrays have room for whole vectors. In a
/// debug build all positions are checked.</summary>
internal static class ArrayVectors
{
    /// <summary>The numbers from a position on, as many as fill 16 bytes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector128<T> Load128<T>(this T[] numbers, int index) where T : struct =>
        Vector128.LoadUnsafe(ref At(numbers, index, Vector128<T>.Count));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<T> Load256<T>(this T[] numbers, int index) where T : struct =>
        Vector256.LoadUnsafe(ref At(numbers, index, Vector256<T>.Count));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector512<T> Load512<T>(this T[] numbers, int index) where T : struct =>
        Vector512.LoadUnsafe(ref At(numbers, index, Vector512<T>.Count));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void StoreTo<T>(this Vector256<T> vector, T[] numbers, int index) where T : struct =>
        vector.StoreUnsafe(ref At(numbers, index, Vector256<T>.Count));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void StoreTo<T>(this Vector128<T> vector, T[] numbers, int index) where T : struct =>
        vector.StoreUnsafe(ref At(numbers, index, Vector128<T>.Count));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void StoreTo<T>(this Vector512<T> vector, T[] numbers, int index) where T : struct =>
        vector.StoreUnsafe(ref At(numbers, index, Vector512<T>.Count));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static ref T At<T>(T[] numbers, int index, int count) where T : struct
    {
#if DEBUG
        _ = numbers.AsSpan(index, count);
#endif
        return ref numbers[index];
    }
}
