namespace RayCaster.Engine.Tests.Pictures;

/// <summary>The references of the course's tests, drawn the fast way; those with meshes, too.</summary>
public class ReferencePicturesTests
{
    public static TheoryData<string> References => [.. Reference.Names];

    [Theory]
    [MemberData(nameof(References))]
    public void ThePictureIsTheOneThatPovRayDraws(string name) => PictureAssert.Equal(name, Renderer.Render(Reference.SceneOf(name)));

    /// <summary>A reference that a shift by half a pixel does not change would show few other errors.</summary>
    [Theory]
    [MemberData(nameof(References))]
    public void EveryReferenceNoticesHalfAPixel(string name)
    {
        var picture = Renderer.Render(Reference.HalfAPixelAway(Reference.SceneOf(name)));
        Assert.False(new ReferenceComparison(Reference.Of(name), picture).IsEqual);
    }
}
