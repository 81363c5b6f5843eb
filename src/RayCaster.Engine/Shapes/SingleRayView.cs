namespace RayCaster.Engine;

/// <summary>A scalar shape, which is intersected ray by ray.</summary>
internal sealed class SingleRayView(Model model) : ModelView
{
    public override void Intersect(RayStream rays, int index) => rays.MeetOneByOne(model, index);
}
