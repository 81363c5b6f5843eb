namespace RayCaster.Engine;

/// <summary>A scalar shape, which is intersected ray by ray.</summary>
internal sealed class SingleRayView(Model model, Camera camera) : ModelView
{
    public override Tile Extent { get; } =
        model.Bounds is { } bounds ? Tile.Of(bounds.PaddedFrom(camera.Position), camera) : Tile.Everywhere;

    public override void Intersect(RayStream rays, int index) => rays.IntersectOneByOne(model, index);
}
