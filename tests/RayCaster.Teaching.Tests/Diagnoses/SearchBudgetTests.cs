namespace RayCaster.Teaching.Tests.Diagnoses;

/// <summary>A search that has done its work tells what it has found, and that it has left something out; how much it does is the same everywhere.
/// </summary>
public class SearchBudgetTests
{
    private const long Half = 200_000_000; // about, of what the picture takes

    private static readonly Scene room = SceneFolder.Read(SceneFolder.FileOf("room")).WithSize(60, 60);
    private static readonly Picture wrong = MistakeCatalog.Draw(
        room, [MistakeCatalog.Named("rows")!, MistakeCatalog.Named("bgr")!, MistakeCatalog.Named("fov-horiz")!]);

    [Theory]
    [InlineData(0)]
    [InlineData(Half / 10)]
    [InlineData(Half)]
    public void ADiagnosisEndsWhenItsWorkIsDone(long work)
    {
        var all = new SearchBudget(long.MaxValue);
        var budget = new SearchBudget(work);
        Diagnosis.Of(room, wrong, all);
        var diagnosis = Diagnosis.Of(room, wrong, budget);
        Assert.NotEqual(Finding.Matches, diagnosis.Finding);
        Assert.Equal("the usual amount of work", budget.UsedUp);
        Assert.InRange(budget.Done, work, work + all.Done / 4);
    }

    [Fact]
    public void ItsWorkDoesNotDependOnTheNumberOfThreads()
    {
        var (one, many) = (new SearchBudget(Half), new SearchBudget(Half));
        Assert.Equal(Json(1, one), Json(8, many));
        Assert.Equal(one.Done, many.Done);

        static string Json(int threads, SearchBudget budget) =>
            DiagnosisReport.Json(new SceneDiagnosis(room, threads, budget: budget).Judge(wrong), (60, 60), (60, 60), [], null);
    }

    [Fact]
    public void ItEndsWhenItsTimeIsOverAlthoughItsWorkIsNotDone()
    {
        var budget = new SearchBudget(long.MaxValue, TimeSpan.Zero);
        Diagnosis.Of(room, wrong, budget);
        Assert.Equal("0 s of processor time", budget.UsedUp);
        Assert.InRange(budget.Done, 0, Half / 10);
    }

    [Fact]
    public void ACancelledDiagnosisEnds()
    {
        var budget = new SearchBudget(long.MaxValue, TimeSpan.FromHours(1), new(canceled: true));
        Diagnosis.Of(room, wrong, budget);
        Assert.NotNull(budget.UsedUp);
        Assert.InRange(budget.Done, 0, Half / 10);
    }

    [Fact]
    public void WhatWasNotTriedIsNamed()
    {
        var fitness = SceneFitness.Of([room], budget: new(0));
        Assert.True(fitness.IsCut);
        Assert.NotEmpty(fitness.NotTried);
        Assert.Contains("Not tried, since the time is over (--all tries them): ", FitnessReport.Text(fitness));
    }

    [Fact]
    public void WithWorkEnoughNothingIsLeftOut()
    {
        var budget = new SearchBudget(long.MaxValue, TimeSpan.FromHours(1));
        Assert.Equal("bgr", Diagnosis.Of(room, MistakeCatalog.Draw(room, [MistakeCatalog.Named("bgr")!]), budget).Suspects[0].Mistakes.Single().Id);
        Assert.Null(budget.UsedUp);
    }
}
