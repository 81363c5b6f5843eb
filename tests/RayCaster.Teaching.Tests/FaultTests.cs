namespace RayCaster.Teaching.Tests;

public sealed class FaultTests
{
    [Fact]
    public void InTheReleasedProgramItIsTheProgramsFault() => Assert.Equal(
        "raycaster: internal error: boom\nThis is a fault of raycaster, please report it.",
        Fault.InWords("raycaster", new Exception("boom"), false));

    [Fact]
    public void AfterAChangeOfTheLibraryTheChangeIsSuspected() => Assert.Equal(
        "raycaster: DivideByZeroException: boom\nsrc/RayCaster was changed, and the change may be the cause: \"git diff src/RayCaster\" shows it.",
        Fault.InWords("raycaster", new AggregateException(new DivideByZeroException("boom")), true));

    [Fact]
    public void TheClassOfTheLibraryThatFailedIsNamed()
    {
        var fault = Assert.ThrowsAny<Exception>(() => ScalarRenderer.Render(null!));
        Assert.StartsWith("raycaster: NullReferenceException in ScalarRenderer: ", Fault.InWords("raycaster", fault, true));
    }
}
