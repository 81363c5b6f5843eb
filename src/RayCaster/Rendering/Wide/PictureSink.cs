namespace RayCaster;

/// <summary>Writes the pixels of some lines of a picture.</summary>
/// <param name="shader">Turns hits into bytes.</param>
/// <param name="rgb">Room for the lines, three bytes a pixel.</param>
/// <param name="width">Pixels in a line.</param>
/// <param name="topRow">The row, from the bottom, that is the first of the lines.</param>
internal sealed class PictureSink(SpanShader shader, byte[] rgb, int width, int topRow) : ISpanSink
{
    /// <inheritdoc/>
    public void Take(RaySpan span) =>
        shader.Shade(span, rgb.AsSpan(3 * ((topRow - span.Row) * width + span.Column), 3 * span.Length));
}
