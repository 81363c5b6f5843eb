using System.Runtime.Intrinsics;

namespace RayCaster;

/// <summary>Writes the pixels of some lines of a picture.</summary>
/// <param name="shader">Turns hits into bytes.</param>
/// <param name="rgb">Room for the lines, three bytes a pixel.</param>
/// <param name="width">Pixels in a line.</param>
/// <param name="topRow">The row, from the bottom, that is the first of the lines.</param>
internal sealed class PictureSink(SpanShader shader, byte[] rgb, int width, int topRow) : ISpanSink
{
    /// <inheritdoc/>
    public void Take(RaySpan span) => shader.Shade(span, rgb, PlaceOf(span.Column, span.Row), -3 * width);

    /// <inheritdoc/>
    public void TakeMiss(in Tile part)
    {
        for (var row = part.Row; row < part.EndRow; row++) shader.ShadeMiss(rgb.AsSpan(PlaceOf(part.Column, row), 3 * part.Width));
    }

    /// <inheritdoc/>
    public void TakeCover(CoveredPart covered, ModelView view, int index)
    {
        var part = covered.Part;
        if (RoughBytes.IsSupported && ((ICoveringView)view).Paint(covered, index, rgb, PlaceOf(part.Column, part.Row), -3 * width)) return;
        for (var column = part.Column; column < part.EndColumn; column += RaySpan.MaxLength)
        {
            var length = Math.Min(RaySpan.MaxLength, part.EndColumn - column);
            if (Vector512.IsHardwareAccelerated) TakeRows<WidePacket>(covered.Span, part with { Column = column, Width = length }, view, index);
            else TakeRows<Packet>(covered.Span, part with { Column = column, Width = length }, view, index);
        }
    }

    /// <inheritdoc/>
    public bool TryTake(in Tile tile, ModelView view, int index) =>
        view is IPaintingView painting && painting.Paint(shader.Scene, index, rgb, PlaceOf(tile.Column, tile.Row), -3 * width);

    private void TakeRows<N>(RaySpan span, in Tile part, ModelView view, int index) where N : struct, IPacket<N>
    {
        span.Enter<N>(part.Column, part.Width);
        for (var row = part.Row; row < part.EndRow; row++)
        {
            span.Aim<N>(row);
            view.Meet(span, index);
            Take(span);
        }
    }

    private int PlaceOf(int column, int row) => 3 * ((topRow - row) * width + column);
}
