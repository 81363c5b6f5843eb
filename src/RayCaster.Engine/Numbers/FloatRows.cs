namespace RayCaster.Engine;

// The build makes overloads for vectors of twice the length of this file (RayCaster.Engine.csproj).

internal static partial class FloatBytes
{
    /// <summary>The whole parts of three channels, packed into one int.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<int> Packed(Vector256<float> r, Vector256<float> g, Vector256<float> b) =>
        Vector256.ConvertToInt32Native(r) | (Vector256.ConvertToInt32Native(g) << 8) | (Vector256.ConvertToInt32Native(b) << 16);

    /// <summary>Writes three bytes of each pixel.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Store(Vector256<int> pixels, byte[] rgb, int place)
    {
        var bytes = InARow(pixels);
        bytes.GetLower().StoreTo(rgb, place);
        bytes.GetUpper().GetLower().StoreTo(rgb, place + Vector256<byte>.Count / 2);
    }

    /// <summary>Writes as many bytes of the first pixels as there is room for.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void StoreFew(in Vector256<int> pixels, Span<byte> to)
    {
        var bytes = InARow(pixels);
        for (var i = 0; i < to.Length; i++) to[i] = bytes[i];
    }
}

internal readonly partial struct FloatLevel
{
    /// <summary>The level is certainly not less than this.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector256<float> Least(Vector256<float> t) => Vector256.FusedMultiplyAdd(t, Vector256.Create(slope), Vector256.Create(least));

    /// <summary>The level is certainly not more than this.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector256<float> Most(Vector256<float> t) => Vector256.FusedMultiplyAdd(t, Vector256.Create(slope), Vector256.Create(most));
}
