using System.Text;
using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Serialization;

namespace RayCaster.Live;

/// <summary>What the server tells a page, as JSON. Each message has a "kind".</summary>
internal static class Messages
{
    /// <summary>Of more models the page lists only the first: no person reads a list of a thousand.</summary>
    public const int MostModels = 500;

    private static readonly JsonSerializerOptions options = new(JsonSerializerDefaults.Web)
    {
        NumberHandling = JsonNumberHandling.AllowNamedFloatingPointLiterals, // t of a ray that hits nothing is Infinity
        Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping,
        Converters = { new JsonStringEnumConverter(JsonNamingPolicy.CamelCase) },
    };

    /// <summary>Any message.</summary>
    public static byte[] Of(object message) => JsonSerializer.SerializeToUtf8Bytes(message, options);

    /// <summary>What the scene file says.</summary>
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
            Problems = state.Problems.Take(SceneReading.Printed).Select(problem => OfProblem(live, problem)),
            More = Math.Max(0, state.Problems.Count - SceneReading.Printed),
            Width = camera?.Width ?? 0,
            Height = camera?.Height ?? 0,
            ShownWidth = width,
            ShownHeight = height,
            Models = state.Scene?.Models.Take(MostModels).Select((model, i) => new
            {
                Name = string.IsNullOrEmpty(model.Name) ? $"models[{i}]" : model.Name,
                Type = TypeOf(model),
                Color = Hex(model.Color.ToBytes()),
            }),
            ModelCount = state.Scene?.Models.Count ?? 0,
        });
    }

    /// <summary>What keeps the code from being built.</summary>
    public static byte[] OfCode(IReadOnlyList<CodeError> errors) => Of(new
    {
        Kind = "code",
        Errors = errors.Take(SceneReading.Printed).Select(error => new
        {
            error.Message,
            Place = $"{error.File}:{error.Line}:{error.Column}",
            Link = LinkTo(error.File, error.Line, error.Column),
        }),
        More = Math.Max(0, errors.Count - SceneReading.Printed),
    });

    /// <summary>A camera as it stands in a scene file.</summary>
    public static byte[] OfCamera(Camera camera, bool isMoved) => Of(new
    {
        Kind = "camera",
        Moved = isMoved,
        Position = Numbers(camera.Position),
        Target = Numbers(camera.Target),
        camera.FovY,
    });

    /// <summary>What is under the pointer.</summary>
    public static byte[] OfHover(Scene scene, int column, int line)
    {
        var ray = ScalarRenderer.Cast(scene, column, scene.Camera.Height - 1 - line);
        var (r, g, b) = scene.Shade(ray.HitParameter, ray.HitModel).ToBytes();
        var model = -1;
        for (var i = 0; ray.HitModel is not null && model < 0; i++)
            if (ReferenceEquals(scene.Models[i], ray.HitModel)) model = i;
        return Of(new
        {
            Kind = "hover",
            Column = column,
            Line = line,
            Row = scene.Camera.Height - 1 - line,
            Model = model < 0 ? "the background" : scene.Models[model].Name is { Length: > 0 } name ? name : $"models[{model}]",
            T = ray.HitParameter,
            Depth = ray.HitParameter * -(ray.Direction * scene.Camera.W),
            Bytes = (int[])[r, g, b],
        });
    }

    /// <summary>How a pixel came about, with the drawing of its ray.</summary>
    public static byte[] OfExplanation(Scene scene, int column, int line, Picture? mine, int version)
    {
        var pixel = PixelExplanation.Of(scene, column, line);
        var text = pixel.ToJson(mine is null ? null : ReferenceExplanation.Of(pixel, mine));
        var section = JsonSerializer.Serialize(RaySection.Of(pixel), options);
        return Encoding.UTF8.GetBytes($$"""{"kind":"explanation","version":{{version}},"pixel":{{text}},"section":{{section}}}""");
    }

    /// <summary>What became of the rays, model by model.</summary>
    public static byte[] OfLedger(HitLedger ledger, int version) => Of(new
    {
        Kind = "ledger",
        Version = version,
        ledger.Rays,
        Models = ledger.Models.Take(MostModels).Select(entry => new
        {
            Shows = entry[Outcome.Shows],
            Hidden = entry[Outcome.Hidden],
            Reason = entry[Outcome.Shows] > 0 ? "" : InWords(entry.Reason),
        }),
        Report = ledger.Report(),
    });

    /// <summary>As a style sheet writes a colour.</summary>
    public static string Hex((byte R, byte G, byte B) color) => $"#{color.R:x2}{color.G:x2}{color.B:x2}";

    private static object OfProblem(LiveScene live, Problem problem) => new
    {
        problem.IsError,
        problem.Message,
        problem.Excerpt,
        Place = problem.Line > 0 ? $"{problem.File}:{problem.Line}:{problem.Column}" : problem.File,
        Link = LinkTo(live.FullPath, problem.Line, problem.Column),
    };

    /// <summary>Opens VS Code at a place.</summary>
    private static string LinkTo(string file, int line, int column) =>
        $"vscode://file/{Uri.EscapeDataString(file.Replace('\\', '/').TrimStart('/')).Replace("%2F", "/")}{(line > 0 ? $":{line}:{column}" : "")}";

    private static string TypeOf(Model model) => model.GetType() is { IsGenericType: true } type
        ? type.GetGenericArguments()[0].Name.ToLowerInvariant()
        : model.GetType().Name.ToLowerInvariant();

    private static string InWords(Outcome outcome) => outcome switch
    {
        Outcome.Hidden => "hidden by nearer models",
        Outcome.Behind => "behind the camera",
        Outcome.UnderBias => "nearer than bias",
        Outcome.BeforeNear => "nearer than zNear",
        Outcome.BeyondFar => "beyond zFar",
        Outcome.Outside or Outcome.PassesBy => "the rays pass it by",
        Outcome.Parallel => "the rays run along it",
        _ => "its formula gives no number",
    };

    private static double[] Numbers(Vector3 v) => [v.X, v.Y, v.Z];
}
