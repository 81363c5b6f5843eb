namespace RayCaster.Engine;

/// <summary>One thread's consumer of hits that writes the pixels of some lines of a picture.</summary>
internal sealed class PictureConsumer(HitShader shader, int width) : IHitConsumer
{
    private byte[] rgb = [];
    private int topRow;

    /// <summary>Paints covered parts without exact hits; made when it is first needed.</summary>
    private FloatPainter Painter => field ??= new(shader.Scene);

    /// <param name="rgb">Room for the lines, three bytes a pixel.</param>
    /// <param name="topRow">The row, from the bottom, that is the first of the lines.</param>
    public void SetTarget(byte[] rgb, int topRow) => (this.rgb, this.topRow) = (rgb, topRow);

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public void Consume(RayStream rays) => shader.Shade(rays, rgb, OffsetOf(rays.Column, rays.Row), -3 * width);

    public void FillBackground(in PixelRect part)
    {
        for (var row = part.Row; row < part.EndRow; row++) shader.ShadeBackground(rgb.AsSpan(OffsetOf(part.Column, row), 3 * part.Width));
    }

    public bool PaintCovered(in CoveredTile covered) =>
        FloatBytes.IsSupported && Painter.Paint(covered, rgb, OffsetOf(covered.Part.Column, covered.Part.Row), -3 * width);

    public bool PaintMesh(in PixelRect tile, ModelView view, int index) =>
        view.Paint(shader.Scene, index, rgb, OffsetOf(tile.Column, tile.Row), -3 * width);

    private int OffsetOf(int column, int row) => 3 * ((topRow - row) * width + column);
}
