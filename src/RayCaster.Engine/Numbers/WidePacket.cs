using System.Runtime.Intrinsics.X86;

namespace RayCaster.Engine;

/// <summary>Eight doubles, for machines that compute with eight at once.</summary>
internal partial struct WidePacket
{
    /// <summary>The lesser of two numbers; where one is NaN, either.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WidePacket Lesser(WidePacket a, WidePacket b) => new() { Lanes = Vector512.MinNative(a.Lanes, b.Lanes) };

    /// <summary>The greater of two numbers; where one is NaN, either.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WidePacket Greater(WidePacket a, WidePacket b) => new() { Lanes = Vector512.MaxNative(a.Lanes, b.Lanes) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Greatest(WidePacket a) => Packet.Greatest(new() { Lanes = Vector256.Max(a.Lanes.GetLower(), a.Lanes.GetUpper()) });

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WidePacket Load(float[] numbers, int first) => new() { Lanes = Vector512.WidenLower(numbers.Load256(first).ToVector512Unsafe()) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3<WidePacket> Gather(Vector3[] vertices, int[] indices, RawSpan<int> triangles, int first, int corner)
    {
        var lower = Packet.Gather(vertices, indices, triangles, first, corner);
        var upper = Packet.Gather(vertices, indices, triangles, first + Packet.Count, corner);
        return new(Pair(lower.X, upper.X), Pair(lower.Y, upper.Y), Pair(lower.Z, upper.Z));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> Narrow(WidePacket lower, WidePacket upper) => Avx512F.IsSupported
        ? Avx512F.ConvertToVector256Single(lower.Lanes)
        : Vector256.Narrow(lower.Lanes.GetLower(), lower.Lanes.GetUpper());

    /// <summary>The whole parts of numbers within ±2³¹.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly Vector256<int> ToInts() => Avx512F.IsSupported
        ? Avx512F.ConvertToVector256Int32WithTruncation(Lanes)
        : Vector256.Create(new Packet(Lanes.GetLower()).ToInts(), new Packet(Lanes.GetUpper()).ToInts());

    /// <summary>Two halves; <see cref="Vector512.Create{T}(Vector256{T}, Vector256{T})"/> would clear the upper one before it is set.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WidePacket Pair(Packet lower, Packet upper) => new() { Lanes = lower.Lanes.ToVector512Unsafe().WithUpper(upper.Lanes) };
}
