namespace RayCaster.Teaching.Tests.Comparison;

/// <summary>Small pictures made by formula, without any symmetry.</summary>
internal static class SomePictures
{
    /// <summary>A shaded ground, a box and a ball before it, all of different colours.</summary>
    public static Picture Still(int width = 96, int height = 64) => Picture.Create(width, height, (x, y) =>
    {
        var (u, v) = ((double)x / width, (double)y / height);
        if (Math.Pow(u - 0.7, 2) + Math.Pow((v - 0.4) * height / width, 2) < 0.02) return (Level(0.9 - 0.5 * u), Level(0.7 - 0.3 * v), (byte)20);
        if (u is > 0.1 and < 0.35 && v is > 0.5 and < 0.8) return ((byte)40, Level(0.6 - 0.2 * u), Level(0.9 - 0.4 * v));
        return v > 0.65 ? (Level(0.3 + 0.2 * v), Level(0.25 + 0.1 * u), (byte)30) : default;
    });

    /// <summary>The same with every pixel changed.</summary>
    public static Picture Map(this Picture picture, Func<(byte R, byte G, byte B), (byte, byte, byte)> change) =>
        Picture.Create(picture.Width, picture.Height, (x, y) => change(picture[x, y]));

    /// <summary>The same with a few pixels changed.</summary>
    public static Picture With(this Picture picture, Action<Picture> change)
    {
        var copy = picture.Map(p => p);
        change(copy);
        return copy;
    }

    private static byte Level(double channel) => (byte)(Math.Clamp(channel, 0, 1) * 255 + 0.5);
}
