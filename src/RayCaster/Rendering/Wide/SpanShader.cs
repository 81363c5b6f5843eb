using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace RayCaster;

/// <summary>Turns the hits of spans into bytes: the formulas of <see cref="Scene.Shade"/> and <see cref="Color.ToBytes"/> for four pixels at once.</summary>
internal sealed class SpanShader
{
    private readonly Scene scene;
    private readonly Color[] colors; // the background, then the models

    public SpanShader(Scene scene)
    {
        this.scene = scene;
        colors = new Color[scene.Models.Count + 1];
        colors[0] = scene.Background;
        for (var i = 1; i < colors.Length; i++) colors[i] = scene.Models[i - 1].Color;
    }

    /// <summary>Writes the pixels of a span.</summary>
    /// <param name="span">The hits.</param>
    /// <param name="rgb">Room for three bytes a pixel.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public void Shade(RaySpan span, Span<byte> rgb)
    {
        // Each store leaves four zeros after its twelve bytes. They fall on pixels that come next, and at last on room of our own: beyond the span
        // another thread may be at work.
        Span<byte> bytes = stackalloc byte[3 * RaySpan.MaxLength + 4];
        ref var first = ref MemoryMarshal.GetReference(bytes);
        for (var i = 0; i < span.Length; i += Packet.Count)
        {
            var models = span.ModelsAt<Packet>(i);
            var isMiss = models < 0;
            var attenuation = Packet.Select(isMiss, 1, scene.Attenuation(span.NearestAt<Packet>(i))); // 1 leaves the background as it is
            ref var a = ref colors[(int)models.Lanes[0] + 1];
            Packet r = a.R, g = a.G, b = a.B;
            if (!Packet.All(Packet.Equal(models, models.Lanes[0])))
            {
                ref var c = ref colors[(int)models.Lanes[1] + 1];
                ref var d = ref colors[(int)models.Lanes[2] + 1];
                ref var e = ref colors[(int)models.Lanes[3] + 1];
                r = new(Vector256.Create(a.R, c.R, d.R, e.R));
                g = new(Vector256.Create(a.G, c.G, d.G, e.G));
                b = new(Vector256.Create(a.B, c.B, d.B, e.B));
            }
            var pixels = Bytes(attenuation * r) | (Bytes(attenuation * g) << 8) | (Bytes(attenuation * b) << 16);
            Vector128.Shuffle(pixels.AsByte(), Vector128.Create((byte)0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14, 255, 255, 255, 255))
                .StoreUnsafe(ref first, (nuint)(3 * i));
        }
        bytes[..rgb.Length].CopyTo(rgb);
    }

    /// <summary>The bytes of a channel of four pixels, each in an int.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector128<int> Bytes(Packet channel) => Color.Level(channel).ToInts();
}
