using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace RayCaster.Engine;

/// <summary>Turns the hits of spans into bytes, sixteen pixels at once, in floats; the pixels that are in doubt go to <see cref="SpanShader"/>.</summary>
internal sealed class RoughShader
{
    /// <summary>With a greater error too many pixels would be in doubt.</summary>
    private const double MostError = 0.001;

    private readonly Scene scene;
    private readonly RoughColors colors;
    private readonly double error;

    private RoughShader(Scene scene, double[] light)
    {
        this.scene = scene;
        colors = new(light);
        // Beyond this t there is no light, whatever the rounding.
        var t = Rounded.From(0, 2 * scene.Camera.Reach);
        var steps = new Rounded(0, colors.MostSteps, 0); // floats know whole numbers exactly
        var level = Color.Level(scene.Attenuation(t) * colors.Step * steps);
        error = level.Error + 255 * colors.Step / 2 + RoughBytes.RoundingOfTheEnds; // a colour is off by half a step
    }

    /// <summary>A shader for a scene; null where the machine or the scene does not suit it.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="light">Red, green and blue of its background, then of its models.</param>
    public static RoughShader? For(Scene scene, double[] light) =>
        RoughBytes.IsSupported && new RoughShader(scene, light) is { error: < MostError } shader ? shader : null;

    /// <summary>Whether a span is of a form that it can shade.</summary>
    public static bool Takes(RaySpan span) => span.IsDense && span.Width % RoughPacket.Count == 0;

    /// <inheritdoc cref="SpanShader.Shade(RaySpan, byte[], int, int)"/>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public unsafe void Shade(RaySpan span, SpanShader exact, byte[] rgb, int first, int step)
    {
        fixed (long* packed = colors.Packed)
        {
            for (var i = 0; i < span.Length; i += 2 * RoughPacket.Count)
            {
                var j = Math.Min(i + RoughPacket.Count, span.Length - RoughPacket.Count); // the last sixteen twice, if they have no partner
                var (lower, upper) = (PlacesAt(span, i), PlacesAt(span, j));
                var isMiss = new RoughPacket(Vector512.Equals(lower, Vector512<int>.Zero).AsSingle(), Vector512.Equals(upper, Vector512<int>.Zero).AsSingle());
                var light = scene.Attenuation(new RoughPacket(NearestAt(span, i), NearestAt(span, j)));
                light = RoughPacket.Select(isMiss, 1, light) * colors.Step; // 1 leaves the background as it is
                var (a, b) = (colors.At(packed, lower), colors.At(packed, upper));
                var red = Color.Level(light * new RoughPacket(a.R, b.R));
                var green = Color.Level(light * new RoughPacket(a.G, b.G));
                var blue = Color.Level(light * new RoughPacket(a.B, b.B));
                Write(span, i, red.Lower, green.Lower, blue.Lower, exact, rgb, first, step);
                Write(span, j, red.Upper, green.Upper, blue.Upper, exact, rgb, first, step);
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Write(
        RaySpan span, int pixel, Vector512<float> r, Vector512<float> g, Vector512<float> b, SpanShader exact, byte[] rgb, int first, int step)
    {
        var slack = Vector512.Create((float)error);
        var place = first + pixel / span.Width * step + 3 * (pixel % span.Width);
        var least = RoughBytes.Packed(r - slack, g - slack, b - slack);
        RoughBytes.Store(least, rgb, place);
        if (Vector512.EqualsAll(least, RoughBytes.Packed(r + slack, g + slack, b + slack))) return;
        exact.Shade(span, pixel, rgb.AsSpan(place, 3 * RoughPacket.Count));
    }

    /// <summary>The places of sixteen pixels' colours.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<int> PlacesAt(RaySpan span, int pixel)
    {
        var models = Vector512.Create(span.ModelsAt<WidePacket>(pixel).ToInts(), span.ModelsAt<WidePacket>(pixel + WidePacket.Count).ToInts());
        return models + Vector512<int>.One;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<float> NearestAt(RaySpan span, int pixel) =>
        Vector512.Narrow(span.NearestAt<WidePacket>(pixel).Lanes, span.NearestAt<WidePacket>(pixel + WidePacket.Count).Lanes);
}
