namespace RayCaster.Live.Tests;

public class LiveOptionsTests
{
    [Fact]
    public void AMisspeltOptionIsToldWithTheRightOne() => Assert.StartsWith(
        "there is no option '--prot'; did you mean '--port'?",
        Assert.Throws<ProblemException>(() => LiveOptions.Parse(["a.json", "--prot", "3"])).Message);

    [Fact]
    public void AValueMayFollowAnEqualsSign() =>
        Assert.Equal(new("a=b.json", "c.png", 8080, true), LiveOptions.Parse(["--port=8080", "a=b.json", "--mine=c.png"]));
}
