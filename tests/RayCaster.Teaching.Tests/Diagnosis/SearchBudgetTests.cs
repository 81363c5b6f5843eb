namespace RayCaster.Teaching.Tests.Diagnosis;

/// <summary>A search that has done its work tells what it has found, and that it has left something out; how much it does is the same everywhere.
/// </summary>
public class SearchBudgetTests
{
    private const long Half = 200_000_000; // about, of what the picture takes

    /// <summary>What is done in any case: the right program is compared, and other numbers in the scene are tried.</summary>
    private static readonly Lazy<long> least = new(() => Spent(new(0))), whole = new(() => Spent(new(long.MaxValue)));

    private static readonly Scene room = SceneFolder.Read(SceneFolder.FileOf("room")).WithSize(60, 60);
    private static readonly Picture wrong = MistakeCatalog.Draw(
        room, [MistakeCatalog.Named("rows")!.Usual, MistakeCatalog.Named("bgr")!.Usual, MistakeCatalog.Named("fov-horiz")!.Usual]);

    [Theory]
    [InlineData(0, Explicit = true)]
    [InlineData(Half / 10, Explicit = true)]
    [InlineData(Half)]
    public void ADiagnosisEndsWhenItsWorkIsDone(long work)
    {
        var budget = new SearchBudget(work);
        var diagnosis = DiagnosisResult.Find(room, wrong, budget);
        Assert.NotEqual(DiagnosisKind.Matches, diagnosis.Kind);
        Assert.Equal("the usual amount of work", budget.UsedUp);
        Assert.InRange(budget.Done, work, work + least.Value + whole.Value / 10);
        Assert.True(budget.Done < whole.Value);
    }

    [Fact]
    public void ItsWorkDoesNotDependOnTheNumberOfThreads()
    {
        var (one, many) = (new SearchBudget(Half), new SearchBudget(Half));
        Assert.Equal(Json(1, one), Json(8, many));
        Assert.Equal(one.Done, many.Done);

        static string Json(int threads, SearchBudget budget) =>
            DiagnosisReport.Json(new Diagnoser(room, threads, budget: budget).Diagnose(wrong), (60, 60), (60, 60), [], null);
    }

    [Fact]
    public void ItEndsWhenItsTimeIsOverAlthoughItsWorkIsNotDone()
    {
        var budget = new SearchBudget(long.MaxValue, TimeSpan.Zero);
        Assert.Equal(least.Value, Spent(budget));
        Assert.Equal("0 s of processor time", budget.UsedUp);
    }

    [Fact]
    public void ACancelledDiagnosisEnds()
    {
        var budget = new SearchBudget(long.MaxValue, TimeSpan.FromHours(1), new(canceled: true));
        Assert.Equal(least.Value, Spent(budget));
        Assert.NotNull(budget.UsedUp);
    }

    [Fact]
    public void WhatWasNotTriedIsNamed()
    {
        var coverage = MutationCoverage.Measure([room], budget: new(0));
        Assert.True(coverage.IsCut);
        Assert.NotEmpty(coverage.NotTried);
        Assert.Contains("shows 0 of the 0 known mistakes that were tried; 95 were not (--all tries them).", CoverageReport.Text(coverage));
        Assert.Contains("Not tried, since the usual amount of work is done (--all tries them): ", CoverageReport.Text(coverage));
    }

    [Fact]
    public void WhatARightPictureCannotProveIsCountedAmongWhatWasTried()
    {
        Assert.Matches("cannot show [0-9]+ of the 95 known mistakes: ", DiagnosisReport.HiddenText(new(room)));
        Assert.Matches(@"cannot show [0-9]+ of the [0-9]+ known mistakes that were tried \(of 95\): ",
            DiagnosisReport.HiddenText(new(room, budget: new(30_000_000))));
    }

    [Fact]
    public void WithWorkEnoughNothingIsLeftOut()
    {
        var budget = new SearchBudget(long.MaxValue, TimeSpan.FromHours(1));
        var picture = MistakeCatalog.Draw(room, [MistakeCatalog.Named("bgr")!.Usual]);
        Assert.Equal("bgr", DiagnosisResult.Find(room, picture, budget).Suspects[0].Mistakes.Single().Id);
        Assert.Null(budget.UsedUp);
    }

    [Fact] // three explain any picture by chance
    public void NoExplanationHasThreeMistakes()
    {
        var scene = SceneFolder.Small("first", 20);
        var picture = ProgramInWords.Draw(scene, "formulas rows & formulas bgr & formulas att-no2 & formulas far-root");
        var hypotheses = new HypothesisSearch(
            [new PictureSample(scene, Renderer.Render(scene), picture, 6000)], new(MistakeCatalog.All, []), null, new(Priors.OtherProgram)).Run();
        Assert.All(hypotheses, of => Assert.InRange(of.Mistakes.Count, 0, 2));
    }

    private static long Spent(SearchBudget budget)
    {
        DiagnosisResult.Find(room, wrong, budget);
        return budget.Done;
    }
}
