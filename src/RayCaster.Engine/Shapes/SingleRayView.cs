namespace RayCaster.Engine;

/// <summary>A model in plain doubles and ifs, which meets rays one by one.</summary>
internal sealed class SingleRayView<N>(Model model) : ModelView<N> where N : struct, IPacket<N>
{
    public override void Meet(RayStream rays, int index) => rays.MeetOneByOne(model, index);
}
