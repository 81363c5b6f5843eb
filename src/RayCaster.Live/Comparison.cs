namespace RayCaster.Live;

/// <summary>The user's own picture beside the scene's, in words and in pictures.</summary>
/// <param name="Version">Counts the comparisons, so that a page knows a new one.</param>
/// <param name="Name">What the picture is called; null where there is none.</param>
/// <param name="Problem">Why it cannot be compared; null where it can.</param>
/// <param name="Result">What came of it; null without a picture.</param>
/// <param name="Scene">The scene that it should show.</param>
/// <param name="SceneName">What that is called.</param>
internal sealed record Comparison(int Version, string? Name, string? Problem, PictureComparison? Result, Scene? Scene, string SceneName)
{
    private static readonly SemaphoreSlim one = new(1, 1); // a diagnosis takes all cores for seconds
    private Task<Diagnosis>? diagnosis;

    /// <summary>What the page is told at once.</summary>
    public byte[] Message() => Messages.Of(new
    {
        Kind = "comparison",
        Name,
        Problem,
        Text = Result is null ? null : ComparisonText.Of(Result, Name!, SceneName),
        Verdict = Result is null ? null : ComparisonText.Of(Result.Likeness),
        HasLayers = Result?.Difference is not null,
        Wrong = Result?.Difference?.Wrong ?? 0,
        Middle = Result?.Difference is { } difference && WrongArea.MiddleOfLargest(difference) is var (x, y) ? (int[])[x, y] : null,
    });

    /// <summary>The picture, where it differs, and the same object by object.</summary>
    public IEnumerable<(Layer, Frame)> Frames()
    {
        if (Result?.Difference is not { } difference) yield break;
        yield return (Layer.Mine, Frame.Of(Result.Mine));
        yield return (Layer.Difference, Frame.Of(SideBySide.Heat(difference)));
        yield return (Layer.ByObject, Frame.Of(WrongArea.ByObject(Result)));
    }

    /// <summary>Which mistake may have made the picture, in words.</summary>
    /// <param name="level">How much is told.</param>
    public async Task<string> DiagnoseAsync(HintLevel level)
    {
        if (Result is null || Scene is null) return "";
        var (width, height) = (Scene.Camera.Width, Scene.Camera.Height);
        var size = (Result.Mine.Width, Result.Mine.Height);
        if (size != (width, height) && size != (height, width)) return "Only a picture of the scene's size can be diagnosed.";
        await one.WaitAsync();
        try
        {
            diagnosis ??= Task.Run(() => Diagnosis.Of(Scene, Result.Mine));
            return DiagnosisReport.Text(await diagnosis, Name!, SceneName, level);
        }
        finally
        {
            one.Release();
        }
    }
}
