namespace RayCaster.Live.Tests;

public class LiveOptionsTests
{
    [Fact]
    public void AMisspeltOptionIsToldWithTheRightOne() => Assert.StartsWith(
        "there is no option '--prot'; did you mean '--port'?",
        Assert.Throws<ProblemException>(() => LiveOptions.Parse(["a.json", "--prot", "3"])).Message);
}
