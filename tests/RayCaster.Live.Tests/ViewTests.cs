namespace RayCaster.Live.Tests;

/// <summary>What stays the same from frame to frame, so that the renderer can keep what depends only on the models.</summary>
public class ViewTests
{
    [Theory]
    [InlineData("")]
    [InlineData("0")]
    [InlineData("1,2")]
    public void EachFrameOfAMovingCameraHasTheSameListOfTheSameModels(string hidden)
    {
        var scene = SceneReader.Read(ProjectFolder.PathOf("scenes/room.json")).Scene!;
        var view = new View(Hidden: hidden);
        var first = view.Of(scene);
        var next = (view with { Camera = CameraMotion.Turn(scene.Camera, 0.5, 0.1), Divisor = 2 }).Of(scene);
        Assert.Same(first.Models, next.Models);
        var places = hidden.Split(',', StringSplitOptions.RemoveEmptyEntries).Select(int.Parse).ToArray();
        for (var i = 0; i < scene.Models.Count; i++)
            if (!places.Contains(i)) Assert.Same(scene.Models[i], first.Models[i]);
            else Assert.Equal(0, Assert.IsType<Mesh>(first.Models[i]).TriangleCount);
    }

    [Fact]
    public void AnotherSelectionIsAnotherList()
    {
        var scene = SceneReader.Read(ProjectFolder.PathOf("scenes/room.json")).Scene!;
        var one = new View(Hidden: "1").Of(scene);
        Assert.NotSame(one.Models, new View(Hidden: "2").Of(scene).Models);
        Assert.Same(scene.Models, new View().Of(scene).Models);
    }
}
