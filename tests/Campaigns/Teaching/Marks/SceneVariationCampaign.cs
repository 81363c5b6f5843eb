namespace RayCaster.Teaching.Tests.Marks;

public class SceneVariationCampaign
{
    [Fact] // its square picture shows "size-mixed" in one wording only, by the last bits of numbers that are equal by symmetry
    public void TheCoursesRoomCanBeVaried() =>
        Assert.NotNull(SceneVariation.Of(File.ReadAllBytes(ProjectFolder.PathOf("scenes/room.json")), "", "anna", ""));
}
