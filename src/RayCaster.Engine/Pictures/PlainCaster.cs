namespace RayCaster.Engine;

/// <summary>One thread's tool for scenes of few models: every ray meets every model that may show near its pixel. What a <see cref="TileCaster{N}"/>
/// does to spare work would take longer to compile than all of that work takes.</summary>
/// <param name="frame">All models as the camera sees them, in the scene's order.</param>
internal sealed class PlainCaster<N>(Frame<N> frame) : IStripCaster where N : struct, IPacket<N>
{
    private readonly ModelView<N>[] views = Array.ConvertAll(frame.Views, view => view.ForThread());
    private readonly RayStream rays = new(frame.Scene.Camera);
    private readonly List<int> near = []; // the models whose extents have pixels of the part

    /// <remarks>Here a strip may have any place and size.</remarks>
    public void Cast(in Tile strip, IHitConsumer consumer)
    {
        for (var column = strip.Column; column < strip.EndColumn; column += RayStream.MaxLength)
            CastPart(strip with { Column = column, Width = Math.Min(RayStream.MaxLength, strip.EndColumn - column) }, consumer);
    }

    private void CastPart(in Tile part, IHitConsumer consumer)
    {
        near.Clear();
        for (var i = 0; i < views.Length; i++)
            if (views[i].Extent.Overlaps(part))
                near.Add(i);
        rays.Enter<N>(part.Column, part.Width);
        for (var row = part.Row; row < part.EndRow; row++)
        {
            rays.Aim<N>(row);
            foreach (var i in near) views[i].Meet(rays, i);
            consumer.Take(rays);
        }
    }
}
