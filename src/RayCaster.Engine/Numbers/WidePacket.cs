using System.Runtime.Intrinsics.X86;

namespace RayCaster.Engine;

/// <summary>Eight doubles, for machines that compute with eight at once; <see cref="Packet"/> with vectors of twice the length.</summary>
internal struct WidePacket : IPacket<WidePacket>
{
    /// <summary>The numbers; as a mask all bits of a lane set for true, none for false.</summary>
    public Vector512<double> Lanes;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public WidePacket(Vector512<double> lanes) => Lanes = lanes;

    public static int Count => Vector512<double>.Count;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator WidePacket(double value) => new() { Lanes = Vector512.Create(value) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WidePacket operator +(WidePacket a, WidePacket b) => new() { Lanes = a.Lanes + b.Lanes };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WidePacket operator -(WidePacket a, WidePacket b) => new() { Lanes = a.Lanes - b.Lanes };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WidePacket operator -(WidePacket a) => new() { Lanes = -a.Lanes };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WidePacket operator *(WidePacket a, WidePacket b) => new() { Lanes = a.Lanes * b.Lanes };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WidePacket operator /(WidePacket a, WidePacket b) => new() { Lanes = a.Lanes / b.Lanes };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WidePacket operator <(WidePacket a, WidePacket b) => new() { Lanes = Vector512.LessThan(a.Lanes, b.Lanes) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WidePacket operator >(WidePacket a, WidePacket b) => new() { Lanes = Vector512.GreaterThan(a.Lanes, b.Lanes) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WidePacket operator <=(WidePacket a, WidePacket b) => new() { Lanes = Vector512.LessThanOrEqual(a.Lanes, b.Lanes) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WidePacket operator >=(WidePacket a, WidePacket b) => new() { Lanes = Vector512.GreaterThanOrEqual(a.Lanes, b.Lanes) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WidePacket operator &(WidePacket a, WidePacket b) => new() { Lanes = a.Lanes & b.Lanes };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WidePacket operator |(WidePacket a, WidePacket b) => new() { Lanes = a.Lanes | b.Lanes };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WidePacket Sqrt(WidePacket x) => new() { Lanes = Vector512.Sqrt(x.Lanes) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WidePacket Min(WidePacket a, WidePacket b) => new() { Lanes = Vector512.Min(a.Lanes, b.Lanes) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WidePacket Max(WidePacket a, WidePacket b) => new() { Lanes = Vector512.Max(a.Lanes, b.Lanes) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WidePacket Select(WidePacket mask, WidePacket a, WidePacket b) =>
        new() { Lanes = Vector512.ConditionalSelect(mask.Lanes, a.Lanes, b.Lanes) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WidePacket Equal(WidePacket a, WidePacket b) => new() { Lanes = Vector512.Equals(a.Lanes, b.Lanes) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint Bits(WidePacket mask) => (uint)mask.Lanes.ExtractMostSignificantBits();

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WidePacket MultiplyAddEstimate(WidePacket a, WidePacket b, WidePacket c) =>
        new() { Lanes = Vector512.MultiplyAddEstimate(a.Lanes, b.Lanes, c.Lanes) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WidePacket Sequence(int first) => new() { Lanes = Vector512.Create((double)first) + Vector512<double>.Indices };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WidePacket Load(double[] numbers, int first) => new() { Lanes = numbers.Load512(first) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Store(double[] numbers, int first) => Lanes.StoreTo(numbers, first);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WidePacket MinNative(WidePacket a, WidePacket b) => new() { Lanes = Vector512.MinNative(a.Lanes, b.Lanes) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WidePacket MaxNative(WidePacket a, WidePacket b) => new() { Lanes = Vector512.MaxNative(a.Lanes, b.Lanes) };

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
