using System.Runtime.Intrinsics.X86;

namespace RayCaster.Engine;

/// <summary>What packets have in common with other vectors of numbers.</summary>
internal static class Lanes
{
    /// <summary>One number in all lanes: the compiler finds the conversion only through this constraint.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static N Broadcast<N>(double number) where N : struct, IReal<N> => number;

    /// <summary>Whether a mask holds in all lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool All<N>(N mask) where N : struct, IPacket<N> => N.Bits(mask) == (1u << N.Count) - 1;

    /// <summary>Prefetches something that is needed soon into the cache. The pointer is only a hint: the program reads nothing through it, so
    /// it may be out of date.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe void Prefetch<T>(ref T thing) where T : struct
    {
        if (Sse.IsSupported) Sse.Prefetch0(Unsafe.AsPointer(ref thing));
    }

    /// <summary>The least of three in each lane; of NaN it promises nothing.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> Least(Vector256<float> a, Vector256<float> b, Vector256<float> c) =>
        Vector256.MinNative(a, Vector256.MinNative(b, c));

    /// <summary>The greatest of three in each lane; of NaN it promises nothing.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> Most(Vector256<float> a, Vector256<float> b, Vector256<float> c) =>
        Vector256.MaxNative(a, Vector256.MaxNative(b, c));
}
