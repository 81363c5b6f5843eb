namespace RayCaster.Ci.Tests;

public class AllowedSkipsTests
{
    [Theory]
    [InlineData("a: T.Windows: for Windows", true, true)]
    [InlineData("a: T.Browser: chromium is missing", true, false)]
    [InlineData("a: T.Browser: strace is missing", false, false)]
    [InlineData("a: T.Other: it was too slow", false, false)]
    public void OnlyWhatTheListNamesMayBeSkipped(string what, bool isAllowed, bool whereAllMustRun)
    {
        var allowed = new AllowedSkips(["# a comment", "", "always  : for Windows$", "missing  : (\\S+) is missing$"],
            (condition, program) => condition == "missing" && program == "chromium");
        Assert.Equal(isAllowed, allowed.Allow(what, all: false));
        Assert.Equal(whereAllMustRun, allowed.Allow(what, all: true));
    }

    [Fact]
    public void ALineWithoutAPatternIsRefused() => Assert.Throws<InvalidDataException>(() => new AllowedSkips(["always"], (_, _) => true));

    [Fact]
    public void TheProjectsListCanBeRead() =>
        _ = new AllowedSkips(File.ReadAllLines(ProjectFolder.PathOf("tests/allowed-skips.txt")), (_, _) => true);
}
