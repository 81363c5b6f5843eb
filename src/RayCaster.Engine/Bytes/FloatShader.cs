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
    public static bool Takes(RayStream rays) => rays.IsDense && rays.Width % FloatPacket.Count == 0;

    /// <inheritdoc cref="HitShader.Shade(RayStream, byte[], int, int)"/>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    public void Shade(RayStream rays, HitShader exact, byte[] rgb, int first, int step)
    {
        var packed = colors.Packed;
        var slack = (FloatPacket)error;
        for (var i = 0; i < rays.Length; i += FloatPacket.Count)
        {
            var colorIndices = rays.ColorIndicesAt(i);
            var light = scene.Attenuation(rays.NearestInFloatsAt(i)) * (FloatPacket)colors.Step;
            var color = FloatColors.At(packed, colorIndices);
            var (r, g, b) = (Color.Level(light * color.R), Color.Level(light * color.G), Color.Level(light * color.B));
            var offset = first + i / rays.Width * step + 3 * (i % rays.Width);
            var (least, most) = (FloatPacket.Pixels(r - slack, g - slack, b - slack), FloatPacket.Pixels(r + slack, g + slack, b + slack));
            var misses = Vector256.Equals(colorIndices, Vector256<int>.Zero);
            // The background is never unsure: it is not attenuated.
            var isUnsure = FloatPacket.WriteRange(least, most, misses, background, rgb, offset) != 0;
            if (isUnsure) exact.Shade(rays, i, rgb.AsSpan(offset, 3 * FloatPacket.Count));
        }
    }
}
