namespace RayCaster.Teaching.Tests.Diagnoses;

/// <summary>A search whose time is over tells what it has found, and that it has left something out.</summary>
public class SearchBudgetTests
{
    private static readonly Scene room = SceneFolder.Read(SceneFolder.FileOf("room")).WithSize(60, 60);

    [Theory]
    [InlineData(0)]
    [InlineData(100)]
    [InlineData(400)]
    public void ADiagnosisEndsWhenItsTimeIsOver(int milliseconds)
    {
        var picture = MistakeCatalog.Draw(room, [MistakeCatalog.Named("rows")!, MistakeCatalog.Named("bgr")!, MistakeCatalog.Named("fov-horiz")!]);
        var budget = new SearchBudget(TimeSpan.FromMilliseconds(milliseconds));
        var diagnosis = Diagnosis.Of(room, picture, budget);
        Assert.NotEqual(Finding.Matches, diagnosis.Finding);
        Assert.True(milliseconds > 0 || budget.LeavesOut);
    }

    [Fact]
    public void ACancelledDiagnosisEnds()
    {
        var budget = new SearchBudget(TimeSpan.FromHours(1), new(canceled: true));
        Diagnosis.Of(room, MistakeCatalog.Draw(room, [MistakeCatalog.Named("bgr")!]), budget);
        Assert.True(budget.LeavesOut);
    }

    [Fact]
    public void WhatWasNotTriedIsNamed()
    {
        var fitness = SceneFitness.Of([room], budget: new(TimeSpan.Zero));
        Assert.True(fitness.IsCut);
        Assert.Equal(fitness.Tested, fitness.NotTried);
        Assert.Contains("Not tried, since the time is over (--all tries them): ", FitnessReport.Text(fitness));
    }

    [Fact]
    public void WithTimeEnoughNothingIsLeftOut()
    {
        var budget = new SearchBudget(TimeSpan.FromHours(1));
        Assert.Equal("bgr", Diagnosis.Of(room, MistakeCatalog.Draw(room, [MistakeCatalog.Named("bgr")!]), budget).Suspects[0].Mistakes.Single().Id);
        Assert.False(budget.LeavesOut);
    }
}
