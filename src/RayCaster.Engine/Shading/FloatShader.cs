namespace RayCaster.Engine;

/// <summary>Turns the hits of streams into bytes, sixteen pixels at once, in floats; <see cref="HitShader"/> computes uncertain bytes.</summary>
internal sealed class FloatShader
{
    /// <summary>With a greater error, too many bytes would be uncertain.</summary>
    private const double MostError = 0.001;

    private readonly Scene scene;
    private readonly FloatColors colors;
    private readonly double error;
    private readonly int background; // its three bytes

    private FloatShader(Scene scene, double[] light, double most, int threads)
    {
        this.scene = scene;
        colors = new(light, most, threads);
        var (r, g, b) = scene.Background.ToBytes();
        background = r | g << 8 | b << 16;
        // Beyond this t there is no light, even after rounding.
        var t = ErrorBound.From(0, 2 * scene.Camera.Reach);
        var steps = new ErrorBound(0, FloatColors.MostSteps, 0); // floats represent integers exactly
        var level = Color.Level(scene.Attenuation(t) * colors.Step * steps);
        error = level.Error + 255 * colors.Step / 2 + FloatBytes.RoundingOfTheEnds; // a colour's error is half a step
    }

    /// <summary>A shader for a scene; null if the machine or the scene does not allow it.</summary>
    /// <param name="light">Red, green and blue of its background, then of its models.</param>
    /// <param name="most">The greatest of them.</param>
    public static FloatShader? For(Scene scene, double[] light, double most, int threads) =>
        FloatBytes.IsWide && new FloatShader(scene, light, most, threads) is { error: < MostError } shader ? shader : null;

    /// <summary>Whether it can shade a stream of this form.</summary>
    public static bool Takes(RayStream rays) => rays.IsDense && rays.Width % WideFloatPacket.Count == 0;

    /// <inheritdoc cref="HitShader.Shade(RayStream, byte[], int, int)"/>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    public void Shade(RayStream rays, HitShader exact, byte[] rgb, int first, int step)
    {
        var packed = colors.Packed;
        for (var i = 0; i < rays.Length; i += 2 * WideFloatPacket.Count)
        {
            // the last sixteen are done twice if they have no partner
            var j = Math.Min(i + WideFloatPacket.Count, rays.Length - WideFloatPacket.Count);
            var (lower, upper) = (PlacesAt(rays, i), PlacesAt(rays, j));
            var light = scene.Attenuation(new WideFloatPacket(NearestAt(rays, i), NearestAt(rays, j))) * colors.Step;
            var (a, b) = (FloatColors.At(packed, lower), FloatColors.At(packed, upper));
            var red = Color.Level(light * new WideFloatPacket(a.R, b.R));
            var green = Color.Level(light * new WideFloatPacket(a.G, b.G));
            var blue = Color.Level(light * new WideFloatPacket(a.B, b.B));
            Write(rays, i, lower, red.Lower, green.Lower, blue.Lower, exact, rgb, first, step);
            Write(rays, j, upper, red.Upper, green.Upper, blue.Upper, exact, rgb, first, step);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Write(
        RayStream rays, int pixel, Vector512<int> places, Vector512<float> r, Vector512<float> g, Vector512<float> b,
        HitShader exact, byte[] rgb, int first, int step)
    {
        var slack = Vector512.Create((float)error);
        var place = first + pixel / rays.Width * step + 3 * (pixel % rays.Width);
        var isMiss = Vector512.Equals(places, Vector512<int>.Zero); // the background is not attenuated, so its bytes are certain
        var least = Vector512.ConditionalSelect(isMiss, Vector512.Create(background), FloatBytes.Packed(r - slack, g - slack, b - slack));
        FloatBytes.Store(least, rgb, place);
        var isSure = isMiss | Vector512.Equals(least, FloatBytes.Packed(r + slack, g + slack, b + slack));
        if (isSure == Vector512<int>.AllBitsSet) return;
        exact.Shade(rays, pixel, rgb.AsSpan(place, 3 * WideFloatPacket.Count));
    }

    /// <summary>The places of sixteen pixels' colours.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<int> PlacesAt(RayStream rays, int pixel)
    {
        var models = Vector512.Create(rays.ModelsAt<WidePacket>(pixel).ToInts(), rays.ModelsAt<WidePacket>(pixel + WidePacket.Count).ToInts());
        return models + Vector512<int>.One;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<float> NearestAt(RayStream rays, int pixel) =>
        Vector512.Narrow(rays.NearestAt<WidePacket>(pixel).Lanes, rays.NearestAt<WidePacket>(pixel + WidePacket.Count).Lanes);
}
