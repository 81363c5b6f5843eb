namespace RayCaster.Engine;

/// <summary>A scalar shape, which is intersected ray by ray.</summary>
internal sealed class SingleRayView(Model model, Camera camera) : ModelView
{
    public override PixelRect ShowsIn { get; } =
        model.Bounds is { } bounds ? new ScreenBounds(camera).TileOf(bounds) : PixelRect.Everywhere;

    public override void Intersect(RayStream rays, int index) => rays.IntersectOneByOne(model, index);
}
