namespace RayCaster.Tests.Pictures;

/// <summary>The scenes, as POV-Ray draws them from the same files by a converter that shares no code with this project.</summary>
public class ReferenceTests
{
    public static TheoryData<string> References => [.. Reference.Names];

    public static TheoryData<string> WithoutMeshes => [.. Reference.WithoutMeshes];

    [Theory]
    [MemberData(nameof(WithoutMeshes))]
    public void TheDefinitionsPictureIsTheOneThatPovRayDraws(string name) =>
        PictureAssert.Equal(name, ScalarRenderer.Render(Reference.SceneOf(name)));

    [Fact]
    public void EverySceneHasAReference() => Assert.Equal(Reference.Scenes, Reference.Names);

    /// <summary>On outlines the comparison is less strict; there must be few.</summary>
    [Theory]
    [MemberData(nameof(References))]
    public void OutlinesAreAtMostTwoPixelsInAHundred(string name)
    {
        var reference = Reference.Read(Reference.Folder, name);
        var (width, height) = (reference.Picture.Width, reference.Picture.Height);
        Assert.InRange(Enumerable.Range(0, width * height).Count(i => reference.IsOutline(i % width, i / width)), 0, width * height / 50);
    }
}
