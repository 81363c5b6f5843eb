namespace RayCaster.Teaching.Visibility;

/// <summary>A picture of a number of each pixel's hit, in place of its colour. Pixels without a hit are black.</summary>
/// <param name="Range">The least and the greatest number; null if nothing is hit, and for models.</param>
/// <param name="Legend">Colours of the numbers from the least to the greatest, equidistant; for models that of each.</param>
public sealed record MapPicture(Picture Picture, (double Least, double Greatest)? Range, IReadOnlyList<(byte R, byte G, byte B)> Legend)
{
    /// <summary>The most pixels of a map. Making it needs up to about 35 bytes of memory for each pixel.</summary>
    public const int MaxPixels = 100_000_000;

    private const int LegendSteps = 32, MaxLegend = 1000;

    /// <summary>Casts all rays of a scene and draws the numbers of their hits; the nearest is the brightest.</summary>
    /// <param name="threads">How many threads cast rays; one per core if left out.</param>
    /// <exception cref="ProblemException">The map has more pixels than <see cref="MaxPixels"/>.</exception>
    public static MapPicture Draw(Scene scene, MapKind kind, int? threads = null)
    {
        var camera = scene.Camera;
        if ((long)camera.Width * camera.Height is > MaxPixels and var pixels)
            throw new ProblemException(FormattableString.Invariant(
                $"a map of {camera.Width} × {camera.Height} has {pixels:N0} pixels; the limit is {MaxPixels:N0}, as it is in memory at once"));
        var hits = new Renderer(scene, threads).CastHits();
        if (kind == MapKind.Model)
            return new(Draw(pixel => OfModel(hits.Model[pixel])), null,
                [.. Enumerable.Range(0, Math.Min(scene.Models.Count, MaxLegend)).Select(OfModel)]);

        var (least, greatest) = (double.PositiveInfinity, double.NegativeInfinity);
        for (var pixel = 0; pixel < hits.Model.Length; pixel++)
            if (hits.Model[pixel] >= 0)
                (least, greatest) = (Math.Min(least, Number(pixel)), Math.Max(greatest, Number(pixel)));
        return new(Draw(pixel => OfNumber(Number(pixel))), least <= greatest ? (least, greatest) : null,
            [.. Enumerable.Range(0, LegendSteps + 1).Select(i => OfNumber(least + (greatest - least) * i / LegendSteps))]);

        Picture Draw(Func<int, (byte, byte, byte)> color) => Picture.Create(hits.Width, hits.Height, (x, y) =>
            y * hits.Width + x is var pixel && hits.Model[pixel] >= 0 ? color(pixel) : default);

        double Number(int pixel) => hits.T[pixel] * (kind == MapKind.T ? 1
            : -(camera.RayThrough(pixel % hits.Width, camera.Height - 1 - pixel / hits.Width).Direction * camera.W));

        (byte, byte, byte) OfNumber(double number) =>
            ColorRamp.Viridis.At((greatest > least ? (greatest - number) / (greatest - least) : 1) * ColorRamp.Viridis.Last);
    }

    /// <summary>A colour for each model. The hue grows by the golden angle, so models that are neighbours in the scene file look
    /// different.</summary>
    private static (byte, byte, byte) OfModel(int model)
    {
        var hue = 6 * Part(0.61803398874989 * model);
        var value = (model % 3) switch { 0 => 1, 1 => 0.75, _ => 0.9 };
        var pale = model % 2 == 0 ? 0.1 : 0.4;
        return new Color(Channel(0), Channel(2), Channel(4)).ToBytes();

        double Channel(int shift)
        {
            var distance = Math.Abs(Part((hue - shift) / 6 + 0.5) * 6 - 3); // from the hue at which the channel is at its maximum
            return value * (pale + (1 - pale) * Math.Clamp(2 - distance, 0, 1));
        }
    }

    /// <summary>The fractional part.</summary>
    private static double Part(double x) => x - Math.Floor(x);
}
