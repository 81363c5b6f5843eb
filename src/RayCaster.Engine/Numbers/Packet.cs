using System.Runtime.Intrinsics.X86;

namespace RayCaster.Engine;

/// <summary>Four doubles, one for each of several pixels side by side: a formula over it gives each lane the bits that <see cref="Scalar"/>
/// gives.</summary>
/// <remarks>Operators set the field themselves: a constructor in each of them makes a kernel's compilation, which a small picture waits for, a tenth
/// longer.</remarks>
internal struct Packet : IPacket<Packet>
{
    /// <summary>The numbers; as a mask all bits of a lane set for true, none for false.</summary>
    public Vector256<double> Lanes;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Packet(Vector256<double> lanes) => Lanes = lanes;

    public static int Count => Vector256<double>.Count;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator Packet(double value) => new() { Lanes = Vector256.Create(value) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Packet operator +(Packet a, Packet b) => new() { Lanes = a.Lanes + b.Lanes };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Packet operator -(Packet a, Packet b) => new() { Lanes = a.Lanes - b.Lanes };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Packet operator -(Packet a) => new() { Lanes = -a.Lanes };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Packet operator *(Packet a, Packet b) => new() { Lanes = a.Lanes * b.Lanes };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Packet operator /(Packet a, Packet b) => new() { Lanes = a.Lanes / b.Lanes };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Packet operator <(Packet a, Packet b) => new() { Lanes = Vector256.LessThan(a.Lanes, b.Lanes) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Packet operator >(Packet a, Packet b) => new() { Lanes = Vector256.GreaterThan(a.Lanes, b.Lanes) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Packet operator <=(Packet a, Packet b) => new() { Lanes = Vector256.LessThanOrEqual(a.Lanes, b.Lanes) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Packet operator >=(Packet a, Packet b) => new() { Lanes = Vector256.GreaterThanOrEqual(a.Lanes, b.Lanes) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Packet operator &(Packet a, Packet b) => new() { Lanes = a.Lanes & b.Lanes };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Packet operator |(Packet a, Packet b) => new() { Lanes = a.Lanes | b.Lanes };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Packet Sqrt(Packet x) => new() { Lanes = Vector256.Sqrt(x.Lanes) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Packet Min(Packet a, Packet b) => new() { Lanes = Vector256.Min(a.Lanes, b.Lanes) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Packet Max(Packet a, Packet b) => new() { Lanes = Vector256.Max(a.Lanes, b.Lanes) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Packet Select(Packet mask, Packet a, Packet b) => new() { Lanes = Vector256.ConditionalSelect(mask.Lanes, a.Lanes, b.Lanes) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Packet Equal(Packet a, Packet b) => new() { Lanes = Vector256.Equals(a.Lanes, b.Lanes) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint Bits(Packet mask) => (uint)mask.Lanes.ExtractMostSignificantBits();

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Packet MultiplyAddEstimate(Packet a, Packet b, Packet c) =>
        new() { Lanes = Vector256.MultiplyAddEstimate(a.Lanes, b.Lanes, c.Lanes) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Packet Sequence(int first) => new() { Lanes = Vector256.Create((double)first) + Vector256<double>.Indices };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Packet Load(double[] numbers, int first) => new() { Lanes = numbers.Load256(first) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Store(double[] numbers, int first) => Lanes.StoreTo(numbers, first);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Greatest(Packet a)
    {
        var pairs = Vector128.Max(a.Lanes.GetLower(), a.Lanes.GetUpper());
        return Math.Max(pairs[0], pairs[1]);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Packet Load(float[] numbers, int first) => new() { Lanes = Vector256.WidenLower(numbers.Load128(first).ToVector256Unsafe()) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3<Packet> Gather(Vector3[] vertices, int[] indices, RawSpan<int> triangles, int first, int corner)
    {
        var vertexIndices = new RawSpan<int>(indices);
        var numbers = RawSpan.NumbersOf(vertices);
        const nint Three = 3; // three times a vertex's index may be more than an int holds
        var (a, b) = (Three * vertexIndices[3 * triangles[first] + corner], Three * vertexIndices[3 * triangles[first + 1] + corner]);
        var (c, d) = (Three * vertexIndices[3 * triangles[first + 2] + corner], Three * vertexIndices[3 * triangles[first + 3] + corner]);
        var z = new Packet(Vector256.Create(numbers[a + 2], numbers[b + 2], numbers[c + 2], numbers[d + 2]));
        var (xyac, xybd) = (Vector256.Create(numbers.Load128(a), numbers.Load128(c)), Vector256.Create(numbers.Load128(b), numbers.Load128(d)));
        if (Avx.IsSupported) return new(new(Avx.UnpackLow(xyac, xybd)), new(Avx.UnpackHigh(xyac, xybd)), z);
        return new(new(Vector256.Create(xyac[0], xybd[0], xyac[2], xybd[2])), new(Vector256.Create(xyac[1], xybd[1], xyac[3], xybd[3])), z);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> Narrow(Packet lower, Packet upper) => Vector256.Narrow(lower.Lanes, upper.Lanes);

    /// <summary>The whole parts of numbers within ±2³¹.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly Vector128<int> ToInts() => Avx.IsSupported
        ? Avx.ConvertToVector128Int32WithTruncation(Lanes)
        : Vector128.Create((int)Lanes[0], (int)Lanes[1], (int)Lanes[2], (int)Lanes[3]);
}
