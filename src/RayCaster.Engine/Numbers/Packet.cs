using System.Runtime.Intrinsics.X86;

namespace RayCaster.Engine;

/// <summary>Four doubles.</summary>
internal partial struct Packet
{
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

    /// <summary>The whole parts of numbers from 0 to 2³¹.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly Vector128<int> ToInts() => Avx.IsSupported
        ? Avx.ConvertToVector128Int32WithTruncation(Lanes)
        : Vector128.Create((int)Lanes[0], (int)Lanes[1], (int)Lanes[2], (int)Lanes[3]);
}
