using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace RayCaster;

/// <summary>Turns the hits of spans into bytes, sixteen pixels at once, in floats; the pixels that are in doubt go to <see cref="SpanShader"/>.</summary>
internal sealed class RoughShader
{
    /// <summary>The background and the models: so many entries have the tables in which a vector's lanes look up a colour.</summary>
    private const int MostColors = 32;

    private const double MostError = 0.001;

    private readonly Scene scene;
    private readonly float[] reds = new float[MostColors], greens = new float[MostColors], blues = new float[MostColors];
    private readonly double error;

    private RoughShader(Scene scene, Color[] colors)
    {
        this.scene = scene;
        var most = 0.0;
        for (var i = 0; i < colors.Length; i++)
        {
            (reds[i], greens[i], blues[i]) = ((float)colors[i].R, (float)colors[i].G, (float)colors[i].B);
            most = Math.Max(most, Math.Max(colors[i].R, Math.Max(colors[i].G, colors[i].B)));
        }
        // Beyond this t there is no light, whatever the rounding.
        var t = Rounded.From(new(0, 2 * scene.Camera.Reach));
        error = Color.Level(scene.Attenuation(t) * most).Error + RoughBytes.RoundingOfTheEnds;
    }

    /// <summary>A shader for a scene; null where the machine or the scene does not suit it.</summary>
    public static RoughShader? For(Scene scene, Color[] colors) =>
        RoughBytes.IsSupported && colors.Length <= MostColors && new RoughShader(scene, colors) is { error: < MostError } shader ? shader : null;

    /// <inheritdoc cref="SpanShader.Shade(RaySpan, byte[], int, int)"/>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public void Shade(RaySpan span, SpanShader exact, byte[] rgb, int first, int step)
    {
        for (var i = 0; i < span.Length; i += 2 * RoughPacket.Count)
        {
            var j = Math.Min(i + RoughPacket.Count, span.Length - RoughPacket.Count); // the last sixteen twice, if they have no partner
            var (lower, upper) = (ColorsAt(span, i), ColorsAt(span, j));
            var isMiss = new RoughPacket(Vector512.Equals(lower, Vector512<int>.Zero).AsSingle(), Vector512.Equals(upper, Vector512<int>.Zero).AsSingle());
            var light = scene.Attenuation(new RoughPacket(Narrow((span.NearestAt<WidePacket>(i), span.NearestAt<WidePacket>(i + WidePacket.Count))), Narrow((span.NearestAt<WidePacket>(j), span.NearestAt<WidePacket>(j + WidePacket.Count)))));
            light = RoughPacket.Select(isMiss, 1, light); // which leaves the background as it is
            var r = Color.Level(light * LookUp(reds, lower, upper));
            var g = Color.Level(light * LookUp(greens, lower, upper));
            var b = Color.Level(light * LookUp(blues, lower, upper));
            Write(span, i, r.Lower, g.Lower, b.Lower, exact, rgb, first, step);
            Write(span, j, r.Upper, g.Upper, b.Upper, exact, rgb, first, step);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Write(
        RaySpan span, int pixel, Vector512<float> r, Vector512<float> g, Vector512<float> b, SpanShader exact, byte[] rgb, int first, int step)
    {
        var slack = Vector512.Create((float)error);
        var place = first + pixel / span.Width * step + 3 * (pixel % span.Width);
        var least = RoughBytes.Packed(r - slack, g - slack, b - slack);
        RoughBytes.Store(least, ref rgb[place]);
        if (Vector512.EqualsAll(least, RoughBytes.Packed(r + slack, g + slack, b + slack))) return;
        exact.Shade(span, pixel, rgb.AsSpan(place, 3 * RoughPacket.Count));
    }

    /// <summary>The places of sixteen pixels' colours in the tables.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<int> ColorsAt(RaySpan span, int pixel) =>
        Avx512F.ConvertToVector512Int32WithTruncation(Narrow((span.ModelsAt<WidePacket>(pixel), span.ModelsAt<WidePacket>(pixel + WidePacket.Count)))) + Vector512<int>.One;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<float> Narrow((WidePacket First, WidePacket Second) numbers) => Vector512.Narrow(numbers.First.Lanes, numbers.Second.Lanes);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static RoughPacket LookUp(float[] table, Vector512<int> lower, Vector512<int> upper)
    {
        var (first, second) = (Vector512.LoadUnsafe(ref table[0]), Vector512.LoadUnsafe(ref table[16]));
        return new(Avx512F.PermuteVar16x32x2(first, lower, second), Avx512F.PermuteVar16x32x2(first, upper, second));
    }
}
