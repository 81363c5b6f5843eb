namespace RayCaster.Files.Tests.Scenes;

public class SpellingTests
{
    private static readonly string[] Known = ["position", "target", "up", "fovY", "width", "height", "zNear", "zFar", "radius", "center"];

    [Theory]
    [InlineData("raduis", "radius")]     // swapped
    [InlineData("redius", "radius")]     // changed
    [InlineData("radus", "radius")]      // left out
    [InlineData("raddius", "radius")]    // added
    [InlineData("centre", "center")]
    [InlineData("FOVY", "fovY")]
    [InlineData("znear", "zNear")]
    [InlineData("eye", "position")]
    [InlineData("lookAt", "target")]
    [InlineData("far", "zFar")]
    [InlineData("lookfrom", "position")] // Ray Tracing in One Weekend
    [InlineData("vfov", "fovY")]
    [InlineData("vup", "up")]
    [InlineData("image_width", "width")]
    [InlineData("look", "target")]
    public void ASlipFindsTheWordThatWasMeant(string written, string meant) => Assert.Equal(meant, Spelling.Nearest(written, Known));

    [Theory]
    [InlineData("noswap", "slab-noswap")]
    [InlineData("boxes.json", "3-boxes.json")]
    [InlineData("slab", "slay")] // several contain it
    public void APartOfOneWordFindsItBeforeAWordThatIsSimilar(string written, string meant) =>
        Assert.Equal(meant, Spelling.Nearest(written, ["whswap", "slay", "slab-noswap", "slab-tmax", "moxes.json", "3-boxes.json"]));

    [Theory]
    [InlineData("")]
    [InlineData("x")]
    [InlineData("gamma")]
    [InlineData("shininess")]
    public void AnotherWordFindsNone(string written) => Assert.Null(Spelling.Nearest(written, Known));

    [Fact]
    public void WhereOnlyTheCaseDiffersTheHintSaysSo() =>
        Assert.Equal("; did you mean \"fovY\"? (case matters)", Spelling.DidYouMean("FovY", Known));
}
