using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace RayCaster;

/// <summary>Moves numbers between arrays of things and lanes, where lane = thing.</summary>
internal static class Lanes
{
    /// <summary>Four points, one to a lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3<Packet> Gather(Vector3[] points, int i0, int i1, int i2, int i3)
    {
        ref readonly var a = ref points[i0];
        ref readonly var b = ref points[i1];
        ref readonly var c = ref points[i2];
        ref readonly var d = ref points[i3];
        var z = Vector256.Create(a.Z, b.Z, c.Z, d.Z);
        if (!Avx.IsSupported)
            return new(new(Vector256.Create(a.X, b.X, c.X, d.X)), new(Vector256.Create(a.Y, b.Y, c.Y, d.Y)), new(z));
        var even = Vector256.Create(XY(a), XY(c));
        var odd = Vector256.Create(XY(b), XY(d));
        return new(new(Avx.UnpackLow(even, odd)), new(Avx.UnpackHigh(even, odd)), new(z));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector128<double> XY(in Vector3 point) =>
        Vector128.LoadUnsafe(ref Unsafe.As<Vector3, double>(ref Unsafe.AsRef(in point)));

    /// <summary>Four times four numbers as floats, a point to each lane; only the first <paramref name="count"/> points are kept.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Scatter(Vector128<float>[] points, int first, int count, Packet x, Packet y, Packet z, Packet w)
    {
        var (a, b, c, d) = (Narrow(x), Narrow(y), Narrow(z), Narrow(w));
        if (Sse.IsSupported && count >= Packet.Count)
        {
            var (ab, cd) = (Sse.UnpackLow(a, b), Sse.UnpackLow(c, d));
            points[first] = Sse.MoveLowToHigh(ab, cd);
            points[first + 1] = Sse.MoveHighToLow(cd, ab);
            (ab, cd) = (Sse.UnpackHigh(a, b), Sse.UnpackHigh(c, d));
            points[first + 2] = Sse.MoveLowToHigh(ab, cd);
            points[first + 3] = Sse.MoveHighToLow(cd, ab);
            return;
        }
        for (var i = 0; i < Math.Min(count, Packet.Count); i++) points[first + i] = Vector128.Create(a[i], b[i], c[i], d[i]);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector128<float> Narrow(Packet x) => Vector128.Narrow(x.Lanes.GetLower(), x.Lanes.GetUpper());

    /// <summary>Eight points as the numbers x, y, z, w of eight lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static (Vector256<float> X, Vector256<float> Y, Vector256<float> Z, Vector256<float> W) Transpose(
        Vector128<float> p0, Vector128<float> p1, Vector128<float> p2, Vector128<float> p3,
        Vector128<float> p4, Vector128<float> p5, Vector128<float> p6, Vector128<float> p7)
    {
        if (!Avx.IsSupported)
        {
            Vector256<float> Of(int i) => Vector256.Create(p0[i], p1[i], p2[i], p3[i], p4[i], p5[i], p6[i], p7[i]);
            return (Of(0), Of(1), Of(2), Of(3));
        }
        var (p04, p15, p26, p37) = (Vector256.Create(p0, p4), Vector256.Create(p1, p5), Vector256.Create(p2, p6), Vector256.Create(p3, p7));
        var (xy01, xy23) = (Avx.UnpackLow(p04, p15).AsDouble(), Avx.UnpackLow(p26, p37).AsDouble());
        var (zw01, zw23) = (Avx.UnpackHigh(p04, p15).AsDouble(), Avx.UnpackHigh(p26, p37).AsDouble());
        return (Avx.UnpackLow(xy01, xy23).AsSingle(), Avx.UnpackHigh(xy01, xy23).AsSingle(),
            Avx.UnpackLow(zw01, zw23).AsSingle(), Avx.UnpackHigh(zw01, zw23).AsSingle());
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
