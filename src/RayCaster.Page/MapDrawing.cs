namespace RayCaster.Page;

/// <summary>A map as a picture, with its legend.</summary>
internal static class MapDrawing
{
    private const int Steps = 33; // colours of the legend

    public static (byte[] Legend, Frame Frame) Of(Scene scene, MapKind kind)
    {
        var map = MapMaker.Make(scene, kind);
        return (LegendOf(kind, map.Range, scene.Models.Count), Frame.Of(MapPicture.Draw(map, kind)));
    }

    /// <summary>The legend's colours: those that <see cref="MapPicture"/> gives to a map of equidistant numbers, or of all models.</summary>
    /// <param name="range">The least and the greatest number; null if no ray hits anything.</param>
    private static byte[] LegendOf(MapKind kind, (float Least, float Greatest)? range, int models)
    {
        var isRamp = kind is MapKind.T or MapKind.Depth && range is not null;
        var (least, greatest) = isRamp ? range!.Value : default;
        var sample = new NumberMap(isRamp ? Steps : Math.Clamp(models, 1, Messages.MaxModels), 1);
        for (var i = 0; i < sample.Width; i++) sample[i, 0] = isRamp ? least + (greatest - least) * i / (Steps - 1) : i;
        var colors = MapPicture.Draw(sample, isRamp ? kind : MapKind.Model);
        return Messages.Of(new
        {
            Kind = "legend",
            Map = kind.Name(),
            Least = least,
            Greatest = greatest,
            Colors = isRamp || kind == MapKind.Model ? Enumerable.Range(0, sample.Width).Select(i => Messages.Hex(colors[i, 0])) : [],
        });
    }
}
