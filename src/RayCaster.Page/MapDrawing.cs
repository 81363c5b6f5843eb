namespace RayCaster.Page;

/// <summary>A map as a picture, with its legend.</summary>
internal static class MapDrawing
{
    public static (byte[] Legend, CanvasImage Image) Of(Scene scene, MapKind kind)
    {
        var map = MapPicture.Draw(scene, kind);
        var (least, greatest) = map.Range ?? default;
        var legend = Messages.Of(new
        {
            Kind = "legend",
            Map = kind.Name(),
            Least = least,
            Greatest = greatest,
            Colors = (map.Range is null && kind != MapKind.Model ? [] : map.Legend.Take(Messages.MaxModels)).Select(Messages.Hex),
        });
        return (legend, CanvasImage.Of(map.Picture));
    }
}
