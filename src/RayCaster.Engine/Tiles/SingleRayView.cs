namespace RayCaster.Engine;

/// <summary>A model in plain doubles and ifs, asked ray by ray.</summary>
internal sealed class SingleRayView(Model model) : ModelView
{
    /// <inheritdoc/>
    public override void Meet(RaySpan span, int index) => span.MeetOneByOne(model, index);
}
