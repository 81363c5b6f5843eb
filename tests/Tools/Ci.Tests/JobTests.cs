namespace RayCaster.Ci.Tests;

public class JobTests
{
    private static readonly IReadOnlyList<Job> table = Job.ReadTable(File.ReadAllText(ProjectFolder.PathOf("tests/Tools/Ci/jobs.json")));

    [Fact]
    public void WhatTheTableNamesIsThere() =>
        Assert.All(table.SelectMany(job => job.Paths), path => Assert.True(Path.Exists(ProjectFolder.PathOf(path)), path));

    [Fact]
    public void EachProjectOfTestsIsInTheSolutionOrInTheTable()
    {
        var solution = File.ReadAllText(ProjectFolder.PathOf("RayCaster.sln")).Replace('\\', '/');
        var projects = FilesInTests("*.Tests.csproj").Concat(FilesInTests("*.Campaigns.csproj"));
        Assert.All(projects, project => Assert.True(solution.Contains(project) || IsInTheTable(Path.GetDirectoryName(project)!), project));
    }

    [Fact]
    public void EachCampaignOfBashIsInTheTable() => Assert.All(FilesInTests("*.sh").Where(file => file.StartsWith("tests/Campaigns/")), script =>
        Assert.True(script.EndsWith("/common.sh") || script == "tests/Campaigns/Foreign/draw.sh" || IsInTheTable(script), script));

    [Fact]
    public void EachTestProjectOfTheSolutionMustLeaveAReport()
    {
        var projects = File.ReadLines(ProjectFolder.PathOf("RayCaster.sln")).Count(line => line.Contains(".Tests.csproj\""));
        Assert.All(table.Where(job => job.Name is "readme-test" or "debug-all"), job => Assert.Equal(projects, job.Reports));
    }

    [Theory]
    [InlineData("src/A/B.cs", true)]
    [InlineData("src/A", true)]
    [InlineData("src/AB.cs", false)]
    [InlineData("tests/a.sh", true)] // which the command names
    [InlineData("tests/b.sh", false)]
    [InlineData("global.json", true)]
    public void AJobRunsAfterChangesOfItsFiles(string changed, bool isDue)
    {
        var job = Of("""{ "name": "a", "minutes": 1, "command": "bash tests/a.sh 1/3", "when": ["src/A"] }""");
        Assert.Equal(isDue, job.IsDue(week: false, [changed]));
        Assert.True(job.IsDue(week: true, [changed]));
    }

    [Fact]
    public void AJobRunsWhereNobodyKnowsWhatHasChanged() =>
        Assert.True(Of("""{ "name": "a", "minutes": 1, "command": "true", "when": ["src/A"] }""").IsDue(week: false, null));

    [Fact]
    public void AJobOfTheWeekRunsOnceAWeek()
    {
        var job = Of("""{ "name": "a", "minutes": 1, "command": "true", "weekly": true }""");
        Assert.False(job.IsDue(week: false, null));
        Assert.True(job.IsDue(week: true, null));
    }

    [Theory]
    [InlineData("""[{ "name": "a", "minutes": 1, "command": "true" }, { "name": "a", "minutes": 1, "command": "true" }]""")]
    [InlineData("""[{ "name": "a", "minutes": 0, "command": "true" }]""")]
    [InlineData("""[{ "name": "a", "command": "true" }]""")]
    [InlineData("""[{ "name": "a", "minutes": 1 }]""")]
    [InlineData("""[{ "name": "a", "minutes": 1, "command": "true", "megabytes": 2000 }]""")] // it does not say why
    [InlineData("""[{ "name": "a", "minutes": 1, "command": "true", "weekyl": true }]""")]
    public void ATableWithAMistakeIsRefused(string table) => Assert.ThrowsAny<Exception>(() => Job.ReadTable(table));

    private static Job Of(string row) => Job.ReadTable($"[{row}]").Single();

    private static bool IsInTheTable(string path) => table.Any(job => job.Paths.Contains(path));

    private static IEnumerable<string> FilesInTests(string pattern) =>
        Directory.GetFiles(ProjectFolder.PathOf("tests"), pattern, SearchOption.AllDirectories)
            .Select(file => Path.GetRelativePath(ProjectFolder.Root, file).Replace('\\', '/'))
            .Where(file => !file.StartsWith("tests/HandedOut/") && !file.Contains("/bin/") && !file.Contains("/obj/"));
}
