using System.Runtime.Intrinsics;

namespace RayCaster.Engine;

/// <summary>
/// One thread's tool for scenes of few models: every ray meets every model that may show near its pixel. What a <see cref="TileCaster"/> does to spare work would take longer to compile than
/// all of that work takes.
/// </summary>
/// <param name="camera">Where the rays start.</param>
/// <param name="views">All models as the camera sees them, in the scene's order.</param>
internal sealed class PlainCaster(Camera camera, ModelView[] views) : IStripCaster
{
    private readonly RaySpan span = new(camera);
    private readonly List<int> near = []; // the models whose extents have pixels of the part

    /// <inheritdoc/>
    /// <remarks>Here a strip may have any place and size.</remarks>
    public void Cast(in Tile strip, ISpanSink sink)
    {
        for (var column = strip.Column; column < strip.EndColumn; column += RaySpan.MaxLength)
        {
            var part = strip with { Column = column, Width = Math.Min(RaySpan.MaxLength, strip.EndColumn - column) };
            if (Vector512.IsHardwareAccelerated) Cast<WidePacket>(part, sink);
            else Cast<Packet>(part, sink);
        }
    }

    private void Cast<N>(in Tile part, ISpanSink sink) where N : struct, IPacket<N>
    {
        near.Clear();
        for (var i = 0; i < views.Length; i++)
            if (views[i].Extent.Overlaps(part))
                near.Add(i);
        span.Enter<N>(part.Column, part.Width);
        for (var row = part.Row; row < part.EndRow; row++)
        {
            span.Aim<N>(row);
            foreach (var i in near) views[i].Meet(span, i);
            sink.Take(span);
        }
    }
}
