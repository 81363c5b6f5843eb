using System.Text.RegularExpressions;

namespace RayCaster.Page;

/// <summary>The comparison of the user's own picture with the scene's, in words and in pictures.</summary>
/// <param name="Name">The picture's name; null if there is no picture.</param>
/// <param name="Problem">Why it cannot be compared; null if it can.</param>
/// <param name="Mine">The picture; null if it cannot be compared.</param>
internal sealed partial record Comparison(string? Name, string? Problem, Picture? Mine, Scene Scene, string SceneName)
{
    private static readonly SemaphoreSlim turn = new(1, 1); // a diagnosis takes all cores for seconds
    private DiagnosisResult? diagnosis;
    private bool isCut;

    private PictureComparison? Result => Mine is null ? null : field ??= PictureComparison.With(Scene, Mine);

    public ComparisonMessage Message() => new(Name, Problem,
        Result is null ? null : ForPage(ComparisonText.Format(Result, Name!, SceneName)),
        Result is null ? null : ComparisonText.Format(Result.Likeness),
        HasLayers: Result?.Difference is not null,
        Middle: Result?.Difference?.WrongMiddle is var (x, y) ? [x, y] : null);

    public IEnumerable<(Layer, CanvasImage)> Frames()
    {
        if (Result?.Difference is not { } difference) yield break;
        yield return (Layer.Mine, CanvasImage.Of(Mine!));
        yield return (Layer.Difference, CanvasImage.Of(HeatMap.Draw(difference)));
    }

    /// <summary>The difference by object; null if the pictures' sizes differ.</summary>
    public CanvasImage? ByObject() => Result?.Difference is null ? null : CanvasImage.Of(HeatMap.ByModel(Result));

    public async Task<string> DiagnoseAsync(HintLevel level, TimeSpan time, CancellationToken cancellation)
    {
        if (Mine is null) return "";
        if (!Diagnoser.CanJudge(Scene, Mine)) return "The picture must have the scene's size to be diagnosed.";
        await turn.WaitAsync(cancellation);
        try
        {
            if (diagnosis is null)
            {
                var budget = new SearchBudget(lastResort: time, cancellation: cancellation);
                var found = await Task.Run(() => DiagnosisResult.Find(Scene, Mine, budget), CancellationToken.None);
                cancellation.ThrowIfCancellationRequested();
                (diagnosis, isCut) = (found, found.IsOpen && budget.UsedUp is not null);
            }
            return ForPage(DiagnosisReport.Text(diagnosis, Name!, SceneName, level))
                + (isCut ? "\nNot everything was tried: \"raycaster diagnose --all\" takes more time.\n" : "");
        }
        finally
        {
            turn.Release();
        }
    }

    /// <summary>The commands that a text names are the console program's; the page has none.</summary>
    private static string ForPage(string text) => Command().Replace(text, "\"raycaster ");

    [GeneratedRegex("\"(?=(check|compare|diagnose|explain)\\b)")]
    private static partial Regex Command();
}
