using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace RayCaster;

/// <summary>Turns the hits of spans into bytes: the formulas of <see cref="Scene.Shade"/> and <see cref="Color.ToBytes"/> for four pixels at once.</summary>
internal sealed class SpanShader
{
    private readonly Color[]? colors; // the background, then the models; null where the few pixels in doubt ask the models themselves
    private readonly byte[] missed = new byte[3 * Tile.MaxStrip]; // pixels that show the background
    private readonly RoughShader? rough;

    /// <param name="scene">What is drawn.</param>
    /// <param name="isLong">Whether there are pixels enough that rough kernels pay.</param>
    public SpanShader(Scene scene, bool isLong)
    {
        Scene = scene;
        var (r, g, b) = scene.Background.ToBytes();
        for (var i = 0; i < missed.Length; i += 3) (missed[i], missed[i + 1], missed[i + 2]) = (r, g, b);
        rough = isLong ? RoughShader.For(scene) : null;
        if (rough is not null) return;
        colors = new Color[scene.Models.Count + 1];
        colors[0] = scene.Background;
        for (var i = 1; i < colors.Length; i++) colors[i] = scene.Models[i - 1].Color;
    }

    /// <summary>What is drawn.</summary>
    public Scene Scene { get; }

    /// <summary>Writes the pixels of a span.</summary>
    /// <param name="span">The hits.</param>
    /// <param name="rgb">Room for three bytes a pixel.</param>
    /// <param name="first">The place of the lowest row's first pixel; the others of the row follow.</param>
    /// <param name="step">From a pixel's place to that of the one above it.</param>
    public void Shade(RaySpan span, byte[] rgb, int first, int step)
    {
        if (rough is not null && RoughShader.Takes(span)) rough.Shade(span, this, rgb, first, step);
        else
            for (var i = 0; i < span.Length; i += span.Pitch, first += step)
                Shade(span, i, rgb.AsSpan(first, 3 * span.Width));
    }

    /// <summary>Writes some pixels.</summary>
    /// <param name="span">The hits.</param>
    /// <param name="first">The first of the pixels in the span.</param>
    /// <param name="rgb">Three bytes for each of the pixels.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public void Shade(RaySpan span, int first, Span<byte> rgb)
    {
        var packed = Vector128.Create((byte)0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14, 255, 255, 255, 255);
        Span<byte> rest = stackalloc byte[16];
        for (var i = first; rgb.Length > 0; i += Packet.Count)
        {
            var models = span.ModelsAt<Packet>(i);
            var isMiss = models < 0;
            var attenuation = Packet.Select(isMiss, 1, Scene.Attenuation(span.NearestAt<Packet>(i))); // 1 leaves the background as it is
            var a = ColorOf((int)models.Lanes[0]);
            Packet r = a.R, g = a.G, b = a.B;
            if (!Packet.All(Packet.Equal(models, models.Lanes[0])))
            {
                var c = ColorOf((int)models.Lanes[1]);
                var d = ColorOf((int)models.Lanes[2]);
                var e = ColorOf((int)models.Lanes[3]);
                r = new(Vector256.Create(a.R, c.R, d.R, e.R));
                g = new(Vector256.Create(a.G, c.G, d.G, e.G));
                b = new(Vector256.Create(a.B, c.B, d.B, e.B));
            }
            var pixels = Bytes(attenuation * r) | (Bytes(attenuation * g) << 8) | (Bytes(attenuation * b) << 16);
            var bytes = Vector128.Shuffle(pixels.AsByte(), packed);

            // Twelve bytes; the four zeros after them fall on pixels that come next, but not beyond the span, where another thread may be at work.
            if (rgb.Length >= 16)
            {
                bytes.StoreUnsafe(ref MemoryMarshal.GetReference(rgb));
                rgb = rgb[12..];
            }
            else
            {
                bytes.CopyTo(rest);
                rest[..Math.Min(12, rgb.Length)].CopyTo(rgb);
                rgb = rgb[Math.Min(12, rgb.Length)..];
            }
        }
    }

    /// <summary>Writes pixels that show the background.</summary>
    /// <param name="rgb">Room for three bytes a pixel.</param>
    public void ShadeMiss(Span<byte> rgb)
    {
        for (; rgb.Length > missed.Length; rgb = rgb[missed.Length..]) missed.CopyTo(rgb);
        missed.AsSpan(0, rgb.Length).CopyTo(rgb);
    }

    /// <summary>A model's colour; that of the background for −1.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private Color ColorOf(int model) => colors is not null ? colors[model + 1] : model < 0 ? Scene.Background : Scene.Models[model].Color;

    /// <summary>The bytes of a channel of four pixels, each in an int.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector128<int> Bytes(Packet channel) => Color.Level(channel).ToInts();
}
