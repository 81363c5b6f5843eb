namespace RayCaster.Engine;

/// <summary>Casts small pictures of few models; each thread has its own. Each ray is intersected with each model that may show near its pixel:
/// compiling <see cref="TileCaster{N}"/> would take longer than all of that.</summary>
/// <param name="frame">All models as the camera sees them, in the scene's order.</param>
internal sealed class PlainCaster<N>(Frame<N> frame) : IStripCaster where N : struct, IPacket<N>
{
    private readonly ModelView[] views = frame.Views; // the threads can share these: a scene with a mesh is never drawn in this way
    private readonly RayStream rays = new(frame.Scene.Camera);
    private readonly List<int> near = []; // the models that may show in the part

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
            foreach (var i in near) views[i].Intersect(rays, i);
            consumer.Take(rays);
        }
    }
}
