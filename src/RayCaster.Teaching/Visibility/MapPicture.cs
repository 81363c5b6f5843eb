namespace RayCaster.Teaching.Visibility;

/// <summary>Draws a map as a picture. Pixels without a hit are black.</summary>
public static class MapPicture
{
    /// <summary>Makes the picture of a map.</summary>
    public static Picture Draw(NumberMap map, MapKind kind)
    {
        var (least, greatest) = map.Range ?? default;
        return Picture.Create(map.Width, map.Height, (x, y) => Pixel(map[x, y], kind, least, greatest));
    }

    private static (byte, byte, byte) Pixel(float number, MapKind kind, double least, double greatest)
    {
        if (kind == MapKind.Model) return number < 0 ? default : OfModel((int)number);
        if (!float.IsFinite(number)) return default;
        var nearness = greatest > least ? (greatest - number) / (greatest - least) : 1; // the nearest is the brightest
        return ColorRamp.Viridis.At(nearness * ColorRamp.Viridis.Last);
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
