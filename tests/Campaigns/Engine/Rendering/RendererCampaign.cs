namespace RayCaster.Engine.Tests.Rendering;

/// <summary>The fast renderer gives the same model and the same bits of t as the definition.</summary>
public class RendererCampaign
{
    /// <summary>So wide that a row of tiles is drawn in halves, and with triangles that are smaller than a pixel.</summary>
    [Fact]
    public void AVeryWidePictureOfAMeshIsRightInAllItsBands()
    {
        var scene = SceneReader.Read(ProjectFolder.PathOf("scenes/mesh.json")).Scene!;
        scene = scene.WithSize(90_000, 70);
        var middle = (90_000 - 24) / 2; // where the mesh is
        var bytes = new List<byte>();
        new Renderer(scene).Draw(.., part => bytes.AddRange(part));
        var differing = 0;
        for (var y = 0; y < 70; y++)
            for (var x = middle; x < middle + 24; x++)
            {
                var ray = ScalarRenderer.Cast(scene, x, 69 - y);
                var (r, g, b) = scene.Shade(ray.HitParameter, ray.HitModel).ToBytes();
                var at = 3 * (y * 90_000 + x);
                if ((r, g, b) != (bytes[at], bytes[at + 1], bytes[at + 2])) differing++;
            }
        Assert.Equal(0, differing);
    }
}
