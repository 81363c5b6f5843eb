namespace RayCaster.Engine;

/// <summary>Turns the hits of streams into bytes, in floats; <see cref="HitShader"/> computes uncertain bytes.</summary>
internal sealed class FloatShader
{
    /// <summary>With a greater error, too many bytes would be uncertain.</summary>
    private const double MaxError = 0.001;

    private readonly Scene scene;
    private readonly float[] red, green, blue; // of the background, then of the models
    private readonly double error;
    private readonly int background; // its three bytes

    private FloatShader(Scene scene, double[] light, double most)
    {
        this.scene = scene;
        (red, green, blue) = (Channel(0), Channel(1), Channel(2));
        var (r, g, b) = scene.Background.ToBytes();
        background = r | g << 8 | b << 16;
        // Beyond this t there is no light, even after rounding.
        var t = ErrorBound.From(0, 2 * scene.Camera.FadeDistance);
        error = Color.Level(scene.Attenuation(t) * ErrorBound.From(0, most)).Error + FloatBytes.RoundingOfTheEnds;

        float[] Channel(int channel)
        {
            var all = new float[light.Length / 3];
            for (var i = 0; i < all.Length; i++) all[i] = (float)light[3 * i + channel];
            return all;
        }
    }

    /// <summary>A shader for a scene; null if the machine or the scene does not allow it.</summary>
    /// <param name="light">Red, green and blue of its background, then of its models.</param>
    /// <param name="most">The greatest of them.</param>
    public static FloatShader? For(Scene scene, double[] light, double most) =>
        FloatBytes.IsSupported && new FloatShader(scene, light, most) is { error: < MaxError } shader ? shader : null;

    /// <summary>Whether it can shade a stream of this form.</summary>
    public static bool Takes(RayStream rays) => rays.IsDense && rays.Width % FloatPacket.Count == 0;

    /// <inheritdoc cref="HitShader.Shade(RayStream, byte[], int, int)"/>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    public void Shade(RayStream rays, HitShader exact, byte[] rgb, int first, int step)
    {
        RawSpan<float> red = new(this.red), green = new(this.green), blue = new(this.blue);
        var slack = (FloatPacket)error;
        for (var i = 0; i < rays.Length; i += FloatPacket.Count)
        {
            var colorIndices = rays.ColorIndicesAt(i);
            var light = scene.Attenuation(rays.NearestInFloatsAt(i));
            var r = Color.Level(light * At(red, colorIndices));
            var g = Color.Level(light * At(green, colorIndices));
            var b = Color.Level(light * At(blue, colorIndices));
            var offset = first + i / rays.Width * step + 3 * (i % rays.Width);
            var (least, most) = (FloatPacket.Pixels(r - slack, g - slack, b - slack), FloatPacket.Pixels(r + slack, g + slack, b + slack));
            var misses = Vector256.Equals(colorIndices, Vector256<int>.Zero);
            // The background is never unsure: it is not attenuated.
            var isUnsure = FloatPacket.WriteRange(least, most, misses, background, rgb, offset) != 0;
            if (isUnsure) exact.Shade(rays, i, rgb.AsSpan(offset, 3 * FloatPacket.Count));
        }
    }

    /// <summary>The numbers of eight colours. (The gather instruction takes twice as long.)</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static FloatPacket At(RawSpan<float> channel, Vector256<int> colors) => new(Vector256.Create(
        channel[colors[0]], channel[colors[1]], channel[colors[2]], channel[colors[3]],
        channel[colors[4]], channel[colors[5]], channel[colors[6]], channel[colors[7]]));
}
