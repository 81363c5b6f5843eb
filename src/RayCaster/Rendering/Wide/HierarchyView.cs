namespace RayCaster;

/// <summary>A mesh whose triangles are found through a hierarchy.</summary>
internal sealed class HierarchyView(Hierarchy hierarchy) : ModelView
{
    /// <inheritdoc/>
    public override void Meet(RaySpan span, int index)
    {
        for (var i = 0; i < span.Length; i += Packet.Count) span.Keep(i, hierarchy.Nearest(span, i), index);
    }
}
