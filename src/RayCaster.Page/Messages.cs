using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Serialization;

namespace RayCaster.Page;

/// <summary>The server's messages to a page, as JSON. Each has a "kind".</summary>
internal static class Messages
{
    /// <summary>The most models that the page lists: a list of a thousand is too long to read.</summary>
    public const int MaxModels = 500;

    private static readonly JsonSerializerOptions options = new(JsonSerializerDefaults.Web)
    {
        NumberHandling = JsonNumberHandling.AllowNamedFloatingPointLiterals, // t of a ray that hits nothing is Infinity
        Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping,
        Converters = { new JsonStringEnumConverter(JsonNamingPolicy.CamelCase) },
    };

    public static byte[] Of(object message) => JsonSerializer.SerializeToUtf8Bytes(message, options);

    /// <summary>The state of the scene file: the picture's size, the models, the errors.</summary>
    public static byte[] OfScene(LiveScene live, SceneState state)
    {
        var camera = state.Scene?.Camera;
        var (width, height) = camera is null ? default : View.SizeOf(camera);
        return Of(new
        {
            Kind = "scene",
            state.Version,
            live.Path,
            Good = state.IsGood,
            IsGone = !state.IsGood && !Path.Exists(live.FullPath),
            Problems = state.Problems.OrderByDescending(problem => problem.IsError).Take(SceneReading.Printed)
                .Select(problem => Shown(problem, live.FullPath)),
            More = Math.Max(0, state.Problems.Count - SceneReading.Printed),
            Width = camera?.Width ?? 0,
            Height = camera?.Height ?? 0,
            ShownWidth = width,
            ShownHeight = height,
            Models = state.Scene?.Models.Take(MaxModels).Select((model, i) => new
            {
                Name = ModelName.Plain(state.Scene, i),
                Type = model.Kind,
                Color = Hex(model.Color.ToBytes()),
            }),
            ModelCount = state.Scene?.Models.Count ?? 0,
        });
    }

    /// <summary>A fault of the code, often of a formula that was changed; null if there is none any more.</summary>
    public static byte[] OfFault(string? text) => Of(new { Kind = "fault", Text = text });

    public static byte[] OfCamera(Camera camera, bool isMoved) => Of(new
    {
        Kind = "camera",
        Moved = isMoved,
        Position = Numbers(camera.Position),
        Target = Numbers(camera.Target),
        camera.FovY,
    });

    public static byte[] OfHover(Scene scene, int column, int line)
    {
        var row = scene.Camera.Height - 1 - line;
        var hit = ScalarRenderer.Cast(scene, column, row);
        var (r, g, b) = scene.Shade(hit).ToBytes();
        return Of(new
        {
            Kind = "hover",
            Column = column,
            Line = line,
            Row = row,
            Model = ModelName.Plain(scene, hit.Model),
            hit.T,
            Depth = hit.T * -(scene.Camera.RayThrough(column, row).Direction * scene.Camera.W),
            Bytes = (int[])[r, g, b],
        });
    }

    /// <summary>The text of a pixel's explanation, section by section, and the drawing of its ray.</summary>
    public static byte[] OfExplanation(Scene scene, int column, int line, Picture? mine)
    {
        var pixel = new PixelExplanation(scene, column, line);
        var reference = mine is null ? null : ReferenceExplanation.Create(pixel, mine);
        return Of(new
        {
            Kind = "explanation",
            Column = column,
            Line = line,
            Color = Hex(pixel.Bytes),
            Gist = ExplanationText.Gist(pixel, reference),
            Sections = ExplanationText.Sections(pixel, reference),
            Drawing = RaySection.Create(pixel),
        });
    }

    /// <summary>The ledger: in how many pixels each model shows, or why it does not.</summary>
    public static byte[] OfLedger(Scene scene, SceneVisibility ledger) => Of(new
    {
        Kind = "ledger",
        ledger.Rays,
        Models = ledger.Models.Take(MaxModels).Select((entry, i) => new
        {
            Name = ModelName.Plain(scene, i),
            Shows = entry[Outcome.Shows],
            Reason = entry[Outcome.Shows] > 0 ? "" : OutcomeText.Of(entry.Reason).Place,
        }),
        Report = ledger.Report(),
    });

    /// <summary>A colour for a style sheet: "#rrggbb".</summary>
    public static string Hex((byte R, byte G, byte B) color) => $"#{color.R:x2}{color.G:x2}{color.B:x2}";

    private static object Shown(Problem problem, string path) => new
    {
        problem.IsError,
        problem.Message,
        problem.Excerpt,
        Place = problem.Line > 0 ? $"{problem.File}:{problem.Line}:{problem.Column}" : problem.File,
        Link = LinkTo(path, problem.Line, problem.Column),
    };

    /// <summary>A link that opens VS Code at a place.</summary>
    private static string LinkTo(string file, int line, int column) =>
        $"vscode://file/{Uri.EscapeDataString(file.Replace('\\', '/').TrimStart('/')).Replace("%2F", "/")}{(line > 0 ? $":{line}:{column}" : "")}";

    private static double[] Numbers(Vector3 v) => [v.X, v.Y, v.Z];
}
