namespace RayCaster.Teaching.Tests;

public sealed class FaultTests
{
    [Fact]
    public void AFaultOutsideOfTheCoursesLibraryIsTheProgramsOwn() => Assert.Equal(
        "raycaster: internal error: boom\nThis is a fault of raycaster, please report it.",
        Fault.InWords("raycaster", new AggregateException(new DivideByZeroException("boom"))));

    [Fact]
    public void AFaultInATextOfTheProgramIsToldWithItsPlace() => Assert.StartsWith(
        "raycaster: internal error: Mistakes.txt(7): no symptom\n",
        Fault.InWords("raycaster", new TypeInitializationException("MistakeBook", new FormatException("Mistakes.txt(7): no symptom"))));

    [Fact]
    public void AFaultOfTheCoursesLibraryNamesItsClassAndSuspectsAChange()
    {
        var fault = Assert.ThrowsAny<Exception>(() => ScalarRenderer.Render(null!));
        var words = Fault.InWords("raycaster", fault);
        Assert.StartsWith("raycaster: NullReferenceException in ScalarRenderer: ", words);
        Assert.EndsWith("If you changed src/RayCaster, the change may be the cause: \"git diff src/RayCaster\" shows it.", words);
    }
}
