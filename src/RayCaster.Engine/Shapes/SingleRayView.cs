namespace RayCaster.Engine;

/// <summary>A model in plain doubles and ifs, which meets rays one by one.</summary>
/// <typeparam name="N">The kind of packet that the other views use.</typeparam>
internal sealed class SingleRayView<N>(Model model) : ModelView<N> where N : struct, IPacket<N>
{
    /// <inheritdoc/>
    public override void Meet(RaySpan span, int index) => span.MeetOneByOne(model, index);
}
