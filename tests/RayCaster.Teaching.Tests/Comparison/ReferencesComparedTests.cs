namespace RayCaster.Teaching.Tests.Comparison;

/// <summary>What another program draws is the same, and what half a pixel changes is not, with the scene and without it.</summary>
public class ReferencesComparedTests
{
    private static readonly string[] some = ["room", "mesh", "sample-center", "clip-depth"];

    public static IEnumerable<TheoryDataRow<string>> Names =>
        Reference.Names.Select(name => new TheoryDataRow<string>(name) { Explicit = !some.Contains(name) });

    [Theory]
    [MemberData(nameof(Names))]
    public void ThePictureThatPovRayDrawsIsTheSame(string name)
    {
        var (scene, reference) = Read(name);
        var mine = Renderer.Render(scene);
        Assert.True(new PictureComparison(mine, reference, scene).Likeness.IsSame());
        Assert.True(new PictureComparison(mine, reference).Likeness.IsSame());
    }

    private static (Scene Scene, Picture Reference) Read(string name) => (Reference.SceneOf(name), Reference.Read(Reference.Folder, name).Picture);
}
