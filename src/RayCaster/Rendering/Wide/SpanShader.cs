using System.Runtime.CompilerServices;

namespace RayCaster;

/// <summary>Turns the hits of spans into bytes: <see cref="Scene.Shade"/> and <see cref="Color.ToBytes"/>, the same operations for four pixels at once.</summary>
internal sealed class SpanShader
{
    private readonly Scene scene;
    private readonly Color[] colors;                           // the background, then the models
    private readonly (byte R, byte G, byte B) background;

    public SpanShader(Scene scene)
    {
        this.scene = scene;
        colors = new Color[scene.Models.Count];
        for (var i = 0; i < colors.Length; i++) colors[i] = scene.Models[i].Color;
        background = scene.Background.ToBytes();
    }

    /// <summary>Writes the pixels of a span.</summary>
    /// <param name="span">The hits.</param>
    /// <param name="rgb">Room for three bytes a pixel.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public void Shade(RaySpan span, Span<byte> rgb)
    {
        for (var i = 0; i < span.Length; i += Packet.Count)
        {
            var packet = i / Packet.Count;
            var attenuation = scene.Attenuation(span.NearestOf(packet));
            for (var lane = 0; lane < Math.Min(Packet.Count, span.Length - i); lane++)
            {
                var pixel = rgb.Slice(3 * (i + lane), 3);
                var model = span.ModelAt(i + lane);
                (pixel[0], pixel[1], pixel[2]) = model < 0 ? background : (attenuation.Lanes[lane] * colors[model]).ToBytes();
            }
        }
    }
}
