using RayCaster.Tests.Pictures;

namespace RayCaster.Tests.Comparisons;

/// <summary>What another program draws is the same, and what half a pixel changes is not, with the scene and without it.</summary>
public class ReferencesComparedTests
{
    public static TheoryData<string> Names => ReferenceTests.References;

    [Theory]
    [MemberData(nameof(Names))]
    public void ThePictureThatPovRayDrawsIsTheSame(string name)
    {
        var (scene, reference) = Read(name);
        var mine = Renderer.Render(scene);
        Assert.True(new PictureComparison(mine, reference, scene).Likeness.IsSame());
        Assert.True(new PictureComparison(mine, reference).Likeness.IsSame());
    }

    [Theory]
    [MemberData(nameof(Names))]
    public void HalfAPixelIsDifferent(string name)
    {
        var (scene, reference) = Read(name);
        var c = scene.Camera;
        var other = c.Sample == Sample.Corner ? Sample.Center : Sample.Corner;
        var mine = Renderer.Render(scene with
        {
            Camera = new Camera(c.Position, c.Target, c.Up, c.FovY, c.Width, c.Height, c.ZNear, c.ZFar, c.Bias, c.Clip, other),
        });
        Assert.False(new PictureComparison(mine, reference, scene).Likeness.IsSame());
        Assert.False(new PictureComparison(mine, reference).Likeness.IsSame());
    }

    private static (Scene Scene, Picture Reference) Read(string name)
    {
        var reference = Reference.Read(Reference.Folder, name).Picture;
        var scene = SceneReader.Read(Path.Combine(Reference.SceneFolder, name + ".json")).Scene!;
        return (scene with { Camera = scene.Camera.WithSize(reference.Width, reference.Height) }, reference);
    }
}
