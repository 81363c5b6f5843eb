using System.Text;
using static RayCaster.Teaching.Tests.Scenes.SceneVariationTests;

namespace RayCaster.Teaching.Tests.Scenes;

public class SceneVariationCampaign
{
    [Fact(Explicit = true)] // its square picture shows "size-mixed" in one variant only, by the last bits of numbers that are equal by symmetry
    public void TheCoursesRoomCanBeVaried() =>
        Assert.NotNull(SceneVariation.Of(File.ReadAllBytes(ProjectFolder.PathOf("scenes/room.json")), "", "anna", ""));

    [Fact(Explicit = true)]
    public void TheSameSeedGivesTheSameSceneAndAnotherAnother()
    {
        Assert.Equal(annas, Vary("anna"));
        Assert.NotEqual(annas, Vary("boris"));
    }

    [Fact(Explicit = true)]
    public void InAnotherFolderTheSchemaIsFound()
    {
        var weeks = ProjectFolder.PathOf("scenes/weeks");
        var moved = Encoding.UTF8.GetString(SceneVariation.Of(scene, weeks, "anna", Path.Combine(weeks, "..", "my", "anna"))!);
        Assert.Contains("\"$schema\": \"../../scene.schema.json\"", moved);
    }
}
