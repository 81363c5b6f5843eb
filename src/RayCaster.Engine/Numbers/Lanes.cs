using System.Runtime.Intrinsics.X86;

namespace RayCaster.Engine;

/// <summary>SIMD helpers.</summary>
internal static class Lanes
{
    /// <summary>One number in all lanes. For a type like Packet one writes the conversion; this is for a type parameter.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static N Broadcast<N>(double number) where N : struct, IReal<N> => number;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static T At<T>(in Vector256<T> vector, int lane) where T : struct => vector[lane & (Vector256<T>.Count - 1)]; // no range check

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector512<float> Broadcast(in Vector256<float> vector, int lane) => Vector512.Create(At(vector, lane));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool All<N>(N mask) where N : struct, IPacket<N> => N.Bits(mask) == (1u << N.Count) - 1;

    /// <summary>Prefetches something that is needed soon into the cache. The pointer is only a hint: the program reads nothing through it, so
    /// it may be out of date.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe void Prefetch<T>(ref T thing) where T : struct
    {
        if (Sse.IsSupported) Sse.Prefetch0(Unsafe.AsPointer(ref thing));
    }

    /// <summary>The lesser in each lane: a where a &lt; b, else b, so b where a is NaN. This is what x86 does in one instruction; those of
    /// other processors differ where there is NaN.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<T> MinOrLast<T>(Vector256<T> a, Vector256<T> b) where T : struct =>
        X86Base.IsSupported ? Vector256.MinNative(a, b) : Vector256.ConditionalSelect(Vector256.LessThan(a, b), a, b);

    /// <inheritdoc cref="MinOrLast{T}(Vector256{T}, Vector256{T})"/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<T> MaxOrLast<T>(Vector256<T> a, Vector256<T> b) where T : struct =>
        X86Base.IsSupported ? Vector256.MaxNative(a, b) : Vector256.ConditionalSelect(Vector256.GreaterThan(a, b), a, b);

    /// <summary>The least of three; where one is NaN, it or one of the others.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> MinOrLast(Vector256<float> a, Vector256<float> b, Vector256<float> c) => MinOrLast(a, MinOrLast(b, c));

    /// <inheritdoc cref="MinOrLast(Vector256{float}, Vector256{float}, Vector256{float})"/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> MaxOrLast(Vector256<float> a, Vector256<float> b, Vector256<float> c) => MaxOrLast(a, MaxOrLast(b, c));
}
