namespace RayCaster.Engine;

// The build makes the same of WidePacket, with vectors of twice the length (RayCaster.Engine.csproj).

/// <summary>Doubles, one for each of several pixels side by side: a formula over it gives each lane the bits that <see cref="Scalar"/>
/// gives.</summary>
/// <remarks>Operators set the field themselves: a constructor in each of them makes a kernel's compilation, which a small picture waits for, a tenth
/// longer.</remarks>
internal partial struct Packet : IPacket<Packet>
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
}
