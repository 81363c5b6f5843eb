namespace RayCaster.Live;

/// <summary>Sends maps, and the comparison with the user's own picture.</summary>
internal sealed partial class Tab
{
    private HintLevel hint = HintLevel.Question;
    private Comparison? compared; // the comparison that the page knows

    private async Task TellMapAsync(SceneState state)
    {
        if (isMoving || !Takes(Pending.Map) || map is not { } kind) return;
        var scene = (view with { Look = Live.Look.Plain, Model = -1 }).Of(state.Scene!);
        var (legend, frame) = await server.Studio.DoAsync(() => MapDrawing.Of(scene, kind), Outdated());
        await SendAsync(legend);
        await SendFrameAsync(frame, Layer.Map, state.Version, isFinal: true);
    }

    private async Task TellComparisonAsync(SceneState state)
    {
        if (!Takes(Pending.Comparison)) return;
        var (diagnoses, level) = (Takes(Pending.Diagnosis), hint);
        var comparison = await server.Mine.CompareAsync(server.Scene, state, server.Studio).WaitAsync(end.Token);
        if (!ReferenceEquals(comparison, compared))
        {
            compared = comparison;
            await SendAsync(comparison.Message());
            foreach (var (layer, frame) in comparison.Frames()) await SendFrameAsync(frame, layer, state.Version, isFinal: true);
        }
        if (diagnoses) _ = TellDiagnosisAsync(comparison, level);
    }

    /// <summary>Sends the diagnosis later: it takes seconds, in which the page can be used.</summary>
    private async Task TellDiagnosisAsync(Comparison comparison, HintLevel level)
    {
        var text = await comparison.DiagnoseAsync(level);
        if (ReferenceEquals(comparison, compared)) Post(Messages.Of(new { Kind = "diagnosis", Text = text }));
    }

    /// <summary>Compares with the user's picture as it is now.</summary>
    public void CompareAgain()
    {
        lock (sync) pending |= Pending.Comparison | Pending.Explanation;
        Wake();
    }
}
