namespace RayCaster.Engine;

/// <summary>Turns the hits of streams into bytes: the formulas of <see cref="Scene.Shade"/> and <see cref="Color.ToBytes"/> for four pixels at
/// once.</summary>
internal sealed class HitShader
{
    private readonly double[] colors; // red, green and blue of the background, then of the models
    private readonly byte[] missed = new byte[3 * Tile.MaxStrip]; // pixels that show the background

    public HitShader(Scene scene, int threads)
    {
        Scene = scene;
        var (r, g, b) = scene.Background.ToBytes();
        for (var i = 0; i < missed.Length; i += 3) (missed[i], missed[i + 1], missed[i + 2]) = (r, g, b);
        colors = ColorsOf(scene, threads);
    }

    public Scene Scene { get; }

    /// <param name="first">The position of the lowest row's first pixel.</param>
    /// <param name="step">The distance from a pixel to the one above it.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public void Shade(RayStream rays, byte[] rgb, int first, int step)
    {
        for (var i = 0; i < rays.Length; i += rays.Pitch, first += step) Shade(rays, i, rgb.AsSpan(first, 3 * rays.Width));
    }

    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    public void Shade(RayStream rays, int first, Span<byte> rgb)
    {
        var packed = Vector128.Create((byte)0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14, 255, 255, 255, 255);
        for (var j = 0; j < rgb.Length; first += Packet.Count, j += 3 * Packet.Count)
        {
            var models = rays.ModelsAt<Packet>(first);
            var attenuation = Packet.Select(models < 0, 1, Scene.Attenuation(rays.NearestAt<Packet>(first))); // 1 leaves the background as it is
            var places = 3 * models.ToInts() + Vector128.Create(3); // of the models' colours; the background's is 0
            var (a, b, c, d) = (places[0], places[1], places[2], places[3]);
            var pixels = Vector128<int>.Zero;
            for (var channel = 2; channel >= 0; channel--)
            {
                var light = new Packet(Vector256.Create(colors[a + channel], colors[b + channel], colors[c + channel], colors[d + channel]));
                pixels = (pixels << 8) | Color.Level(attenuation * light).ToInts();
            }
            var bytes = Vector128.Shuffle(pixels.AsByte(), packed);

            // Twelve bytes. The four zeros after them fall on pixels that follow, but not beyond the span, where another thread may write.
            if (j + 16 <= rgb.Length) bytes.CopyTo(rgb[j..]);
            else
                for (var k = j; k < Math.Min(j + 12, rgb.Length); k++) rgb[k] = bytes[k - j];
        }
    }

    public void ShadeBackground(Span<byte> rgb)
    {
        for (; rgb.Length > missed.Length; rgb = rgb[missed.Length..]) missed.CopyTo(rgb);
        missed.AsSpan(0, rgb.Length).CopyTo(rgb);
    }

    private static double[] ColorsOf(Scene scene, int threads)
    {
        var models = scene.Models;
        var colors = new double[3 * models.Count + 3];
        ThreadTeam.Shares(ThreadTeam.SharesOf(models.Count, threads), models.Count, (_, first, end) =>
        {
            for (var i = first; i < end; i++) (colors[3 * i + 3], colors[3 * i + 4], colors[3 * i + 5]) = models[i].Color;
        });
        (colors[0], colors[1], colors[2]) = scene.Background;
        return colors;
    }
}
