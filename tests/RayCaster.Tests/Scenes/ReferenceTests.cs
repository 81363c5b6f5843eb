namespace RayCaster.Tests.Scenes;

/// <summary>The scenes, as POV-Ray draws them from the same files by a converter that shares no code with this project.</summary>
public class ReferenceTests
{
    public static TheoryData<string> WithoutMeshes => [.. Reference.WithoutMeshes];

    [Theory]
    [MemberData(nameof(WithoutMeshes))]
    public void TheDefinitionsPictureIsTheOneThatPovRayDraws(string name) =>
        PictureAssert.Equal(name, ScalarRenderer.Render(Reference.SceneOf(name)));

    [Fact]
    public void EverySceneHasAReference()
    {
        foreach (var name in SceneFolder.Names.Except(Reference.Names))
            Assert.Fail($"scenes/{name}.json has no reference picture. If the scene is your own, move it to scenes/my. Otherwise draw "
                + $"tests/References/{name}.png with POV-Ray: tests/References/remake.sh {name}");
        foreach (var name in Reference.Names.Except(SceneFolder.Names))
            Assert.Fail($"tests/References/{name}.png has no scene: scenes/{name}.json is missing");
    }
}
