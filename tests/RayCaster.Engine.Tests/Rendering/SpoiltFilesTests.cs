namespace RayCaster.Engine.Tests.Rendering;

/// <summary>Scenes that are read from corrupted files are drawn as the definition draws them.</summary>
public class SpoiltFilesTests
{
    [Fact(Explicit = true)]
    public void SpoiltScenesAreDrawn() => Campaign.Run("drawn-scene", 1000, random => new Mutation(random, Corpus.Scenes).Next(), DrawScene);

    [Fact(Explicit = true)]
    public void SpoiltMeshesAreDrawn() => Campaign.Run("drawn-mesh", 1000, random => new Mutation(random, Corpus.Meshes).Next(), DrawMesh);

    private static void DrawScene(SeedFile file)
    {
        if (SceneReader.Parse(file.Bytes, "scene.json", Corpus.SceneFolder).Scene is { Models.Count: <= 2000 } scene) Draw(scene);
    }

    private static void DrawMesh(SeedFile file)
    {
        try
        {
            var mesh = new MeshPlacement(new(1, 1, 1), Vector3.Zero, Vector3.Zero).Place(MeshBytes.Read(file.Name, file.Bytes), out _);
            Draw(new(new Camera(new(3, 2, 1), Vector3.Zero), [mesh]));
        }
        catch (Exception e) when (e is ProblemException or OverflowException)
        {
            // The readers' own tests say how it is refused.
        }
    }

    /// <summary>Small, and where there is little in it also by the definition.</summary>
    private static void Draw(Scene scene)
    {
        scene = scene.WithSize(24, 16);
        var picture = Renderer.Render(scene, threads: 1);
        var triangles = scene.Models.Sum(model => model is Mesh mesh ? mesh.TriangleCount : 1);
        if (triangles < 200) Assert.Equal(ScalarRenderer.Render(scene).Rgb, picture.Rgb);
    }
}
