namespace RayCaster.Engine;

/// <summary>Turns the hits of streams into bytes, in floats; <see cref="HitShader"/> computes uncertain bytes.</summary>
internal sealed class FloatShader
{
    /// <summary>With a greater error, too many bytes would be uncertain.</summary>
    private const double MaxError = 0.001;

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
        var t = ErrorBound.From(0, 2 * scene.Camera.FadeDistance);
        var steps = new ErrorBound(0, FloatColors.MaxSteps, 0); // floats represent integers exactly
        var level = Color.Level(scene.Attenuation(t) * colors.Step * steps);
        error = level.Error + 255 * colors.Step / 2 + FloatBytes.RoundingOfTheEnds; // a colour's error is half a step
    }

    /// <summary>A shader for a scene; null if the machine or the scene does not allow it.</summary>
    /// <param name="light">Red, green and blue of its background, then of its models.</param>
    /// <param name="most">The greatest of them.</param>
    public static FloatShader? For(Scene scene, double[] light, double most, int threads) =>
        FloatBytes.IsSupported && new FloatShader(scene, light, most, threads) is { error: < MaxError } shader ? shader : null;

    /// <summary>Whether it can shade a stream of this form.</summary>
    public static bool Takes(RayStream rays) => rays.IsDense && rays.Width % FloatBytes.Count == 0;

    /// <inheritdoc cref="HitShader.Shade(RayStream, byte[], int, int)"/>
    public void Shade(RayStream rays, HitShader exact, byte[] rgb, int first, int step)
    {
        if (FloatBytes.IsWide) Shade<WideFloatPacket>(rays, exact, rgb, first, step);
        else Shade<FloatPacket>(rays, exact, rgb, first, step);
    }

    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private void Shade<F>(RayStream rays, HitShader exact, byte[] rgb, int first, int step) where F : struct, IFloatPacket<F>
    {
        var packed = colors.Packed;
        var slack = Lanes.Broadcast<F>(error);
        for (var i = 0; i < rays.Length; i += F.Count)
        {
            var colorIndices = rays.ColorIndicesAt<F>(i);
            var light = scene.Attenuation(rays.NearestInFloatsAt<F>(i)) * Lanes.Broadcast<F>(colors.Step);
            var color = F.ColorsAt(packed, colorIndices);
            var (r, g, b) = (Color.Level(light * color.R), Color.Level(light * color.G), Color.Level(light * color.B));
            var offset = first + i / rays.Width * step + 3 * (i % rays.Width);
            var (least, most) = (F.Pixels(r - slack, g - slack, b - slack), F.Pixels(r + slack, g + slack, b + slack));
            var isUnsure = F.WriteRange(least, most, colorIndices, background, rgb, offset) != 0; // never the background, which is not attenuated
            if (isUnsure) exact.Shade(rays, i, rgb.AsSpan(offset, 3 * F.Count));
        }
    }
}
