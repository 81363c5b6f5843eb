namespace RayCaster.Engine.Tests.Rendering.Meshes;

/// <summary>Meshes of many small triangles over many tiles: groups of them are sorted, hidden by nearer ones, and drawn eight at once.</summary>
public class FineMeshCampaign
{
    [Theory]
    [InlineData(1)]
    [InlineData(4)]
    [InlineData(6)]
    public void MoreSmallTrianglesComeOutToTheBit(int seed) => new FineMeshTests().SmallTrianglesComeOutToTheBit(seed);
}
