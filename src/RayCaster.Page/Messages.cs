namespace RayCaster.Page;

/// <summary>Makes the messages of <see cref="Message"/> that hold more than words.</summary>
internal static class Messages
{
    /// <summary>The most models that the page lists: a list of a thousand is too long to read.</summary>
    private const int MaxModels = 500;

    public static SceneMessage OfScene(LiveScene live, SceneState state)
    {
        var (scene, camera) = (state.Scene, state.Scene?.Camera);
        var (width, height) = camera is null ? default : View.SizeOf(camera);
        return new(state.Version, live.Path, state.IsGood, IsGone: !state.IsGood && !Path.Exists(live.FullPath),
            state.Problems.OrderByDescending(problem => problem.IsError).Take(SceneReading.Printed).Select(problem => Entry(problem, live.FullPath)),
            Math.Max(0, state.Problems.Count - SceneReading.Printed), camera?.Width ?? 0, camera?.Height ?? 0, width, height,
            scene?.Models.Take(MaxModels).Select((model, i) =>
                new ModelEntry(ModelName.Plain(scene, i), model.Kind, Hex(model.Color.ToBytes()))),
            scene?.Models.Count ?? 0);
    }

    public static CameraMessage OfCamera(Camera camera, bool isMoved) =>
        new(isMoved, Numbers(camera.Position), Numbers(camera.Target), camera.FovY);

    public static HoverMessage OfHover(Scene scene, int column, int line)
    {
        var row = scene.Camera.Height - 1 - line;
        var hit = ScalarRenderer.Cast(scene, column, row);
        var (r, g, b) = scene.Shade(hit).ToBytes();
        return new(column, line, row, ModelName.Plain(scene, hit.Model), hit.T,
            Depth: hit.T * -(scene.Camera.RayThrough(column, row).Direction * scene.Camera.W), [r, g, b]);
    }

    public static ExplanationMessage OfExplanation(Scene scene, int column, int line, Picture? mine)
    {
        var pixel = new PixelExplanation(scene, column, line);
        var reference = mine is null ? null : ReferenceExplanation.Create(pixel, mine);
        return new(column, line, Hex(pixel.Bytes), ExplanationText.Gist(pixel, reference), ExplanationText.Sections(pixel, reference),
            RaySection.Create(pixel));
    }

    public static LedgerMessage OfLedger(Scene scene, SceneVisibility ledger) => new(
        ledger.Rays,
        ledger.Models.Take(MaxModels).Select((entry, i) => new LedgerEntry(
            ModelName.Plain(scene, i), entry[Outcome.Shows], entry[Outcome.Shows] > 0 ? "" : OutcomeText.Find(entry.Reason).Place)),
        ledger.Report());

    public static LegendMessage OfLegend(MapPicture map, MapKind kind)
    {
        var (least, greatest) = map.Range ?? default;
        return new(kind.Name(), least, greatest,
            map.Range is null && kind != MapKind.Model ? [] : map.Legend.Take(MaxModels).Select(Hex));
    }

    public static string Hex((byte R, byte G, byte B) color) => $"#{color.R:x2}{color.G:x2}{color.B:x2}";

    private static ProblemEntry Entry(Problem problem, string path) => new(problem.IsError, problem.Message, problem.Excerpt,
        problem.Line > 0 ? $"{problem.File}:{problem.Line}:{problem.Column}" : problem.File, LinkTo(path, problem.Line, problem.Column));

    /// <summary>A link that opens VS Code at a place.</summary>
    private static string LinkTo(string file, int line, int column) =>
        $"vscode://file/{Uri.EscapeDataString(file.Replace('\\', '/').TrimStart('/')).Replace("%2F", "/")}{(line > 0 ? $":{line}:{column}" : "")}";

    private static double[] Numbers(Vector3 v) => [v.X, v.Y, v.Z];
}
