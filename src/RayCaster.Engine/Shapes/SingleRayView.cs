namespace RayCaster.Engine;

/// <summary>A model in plain doubles and ifs, which is intersected ray by ray.</summary>
internal sealed class SingleRayView(Model model) : ModelView
{
    public override void Meet(RayStream rays, int index) => rays.MeetOneByOne(model, index);
}
