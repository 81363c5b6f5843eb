namespace RayCaster.Live;

/// <summary>What a page is told of the user's own picture, and which maps it is shown.</summary>
internal sealed partial class Tab
{
    private HintLevel hint = HintLevel.Question;
    private bool wantsDiagnosis;
    private Comparison? compared; // what the page knows

    private async Task TellMapAsync(SceneState state)
    {
        MapKind kind;
        View seen;
        lock (gate)
        {
            if (!wantsMap || isMoving || map is not { } wanted) return;
            (wantsMap, kind, seen) = (false, wanted, view with { Look = Teaching.Look.Plain, Model = -1 });
        }
        var scene = seen.Of(state.Scene!);
        var drawn = await server.Studio.DoAsync(() => MapDrawing.Of(scene, kind), Outdated());
        await SendAsync(drawn.Legend());
        await SendFrameAsync(drawn.Frame, Layer.Map, state.Version, isFinal: true);
    }

    private async Task TellComparisonAsync(SceneState state)
    {
        HintLevel level;
        bool diagnoses;
        lock (gate)
        {
            if (!wantsComparison) return;
            (wantsComparison, level, diagnoses) = (false, hint, wantsDiagnosis);
        }
        var comparison = await server.Mine.CompareAsync(server.Scene, state, server.Studio, end.Token);
        if (!ReferenceEquals(comparison, compared))
        {
            compared = comparison;
            await SendAsync(comparison.Message());
            foreach (var (layer, frame) in comparison.Frames()) await SendFrameAsync(frame, layer, state.Version, isFinal: true);
        }
        if (diagnoses) TellDiagnosis(comparison, level);
    }

    /// <summary>Comes later: it takes seconds, in which the page goes on.</summary>
    private void TellDiagnosis(Comparison comparison, HintLevel level) => _ = Task.Run(async () =>
    {
        Post(Messages.Of(new { Kind = "diagnosis", Text = await comparison.DiagnoseAsync(level) }));
    });

    /// <summary>Says that there is another picture to compare with, or none.</summary>
    public void LookAtMine()
    {
        lock (gate) (wantsComparison, wantsExplanation) = (true, explained is not null);
        Wake();
    }
}
