namespace RayCaster.Live;

/// <summary>A map as a picture, with its legend.</summary>
/// <param name="Range">The least and the greatest number; null for vectors, and if no ray hits anything.</param>
internal sealed record MapDrawing(MapKind Kind, Frame Frame, (float Least, float Greatest)? Range, int Models)
{
    private const int Steps = 33; // colours of the legend

    public static MapDrawing Of(Scene scene, MapKind kind)
    {
        var map = MapMaker.Make(scene, kind);
        return new(kind, Frame.Of(MapPicture.Draw(map, kind)), map.Range, scene.Models.Count);
    }

    /// <summary>The legend's colours: those that <see cref="MapPicture"/> gives to a map of equidistant numbers, or of all models.</summary>
    public byte[] Legend()
    {
        var isRamp = Kind is MapKind.T or MapKind.Depth && Range is not null;
        var sample = new NumberMap(isRamp ? Steps : Math.Clamp(Models, 1, Messages.MostModels), 1, 1);
        for (var i = 0; i < sample.Width; i++)
            sample[i, 0][0] = isRamp ? Range!.Value.Least + (Range.Value.Greatest - Range.Value.Least) * i / (Steps - 1) : i;
        var colors = MapPicture.Draw(sample, isRamp ? Kind : MapKind.Model);
        return Messages.Of(new
        {
            Kind = "legend",
            Map = Kind.Name(),
            Least = isRamp ? Range!.Value.Least : 0,
            Greatest = isRamp ? Range!.Value.Greatest : 0,
            Colors = isRamp || Kind == MapKind.Model ? Enumerable.Range(0, sample.Width).Select(i => Messages.Hex(colors[i, 0])) : [],
        });
    }
}
