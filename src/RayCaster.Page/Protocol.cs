using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Serialization;

namespace RayCaster.Page;

/// <summary>A message to a page, as JSON: its kind, then what it holds. The scripts read these names, with a small first letter.</summary>
[JsonPolymorphic(TypeDiscriminatorPropertyName = "kind")]
[JsonDerivedType(typeof(SceneMessage), "scene")]
[JsonDerivedType(typeof(FaultMessage), "fault")]
[JsonDerivedType(typeof(CameraMessage), "camera")]
[JsonDerivedType(typeof(HoverMessage), "hover")]
[JsonDerivedType(typeof(ExplanationMessage), "explanation")]
[JsonDerivedType(typeof(LedgerMessage), "ledger")]
[JsonDerivedType(typeof(LegendMessage), "legend")]
[JsonDerivedType(typeof(ComparisonMessage), "comparison")]
[JsonDerivedType(typeof(DiagnosisMessage), "diagnosis")]
[JsonDerivedType(typeof(WrittenMessage), "written")]
[JsonDerivedType(typeof(TextMessage), "text")]
[JsonDerivedType(typeof(RefusedMessage), "refused")]
internal abstract record Message
{
    private static readonly JsonSerializerOptions options = new(JsonSerializerDefaults.Web)
    {
        NumberHandling = JsonNumberHandling.AllowNamedFloatingPointLiterals, // t of a ray that hits nothing is Infinity
        Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping,
    };

    public byte[] ToJson() => JsonSerializer.SerializeToUtf8Bytes(this, options);
}

/// <summary>What is still to be sent to a page.</summary>
[Flags]
internal enum MessageKind
{
    Scene = 1, Hover = 2, Frame = 4, Camera = 8, Explanation = 16, Map = 32, Comparison = 64, Diagnosis = 128, Ledger = 256, All = 511,
}

/// <summary>The state of the scene file: the picture's size, the models, the errors.</summary>
/// <param name="Good">Whether the file describes the scene now.</param>
/// <param name="More">How many further problems there are.</param>
/// <param name="Models">Null if there was no good scene yet.</param>
internal sealed record SceneMessage(
    int Version, string Path, bool Good, bool IsGone, IEnumerable<ProblemEntry> Problems, int More, int Width, int Height, int ShownWidth,
    int ShownHeight, IEnumerable<ModelEntry>? Models, int ModelCount) : Message;

/// <param name="Link">Opens an editor at the place.</param>
internal sealed record ProblemEntry(bool IsError, string Message, string Excerpt, string Place, string Link);
internal sealed record ModelEntry(string Name, string Type, string Color);

/// <summary>A fault of the code, often of a formula that was changed; null if there is none any more.</summary>
internal sealed record FaultMessage(string? Text) : Message;

/// <param name="Moved">Whether it is not the scene's own.</param>
internal sealed record CameraMessage(bool Moved, double[] Position, double[] Target, double FovY) : Message;

/// <summary>What the pixel under the pointer shows.</summary>
internal sealed record HoverMessage(int Column, int Line, int Row, string Model, double T, double Depth, int[] Bytes) : Message;

/// <summary>The text of a pixel's explanation, section by section, and the drawing of its ray.</summary>
internal sealed record ExplanationMessage(
    int Column, int Line, string Color, string Gist, IEnumerable<ExplanationSection> Sections, RayDrawing Drawing) : Message;

/// <summary>A drawing from the side. Points are (u, v).</summary>
/// <param name="Near">The u of the clip plane; null where zNear and zFar are distances, whose sections are circles.</param>
internal sealed record RayDrawing(
    double[] Direction, double? Near, double? Far, DrawnView View, IEnumerable<DrawnModel> Models, IEnumerable<DrawnCrossing> Crossings);
internal sealed record DrawnView(double Left, double Right, double Bottom, double Top);
internal sealed record DrawnModel(string Name, string Color, IEnumerable<double[][]> Lines);
internal sealed record DrawnCrossing(double[] Place, bool Shows, string Label, string Words);

/// <summary>In how many pixels each model shows, or why it does not.</summary>
internal sealed record LedgerMessage(long Rays, IEnumerable<LedgerEntry> Models, string Report) : Message;

internal sealed record LedgerEntry(string Name, long Shows, string Reason);

/// <summary>What the colours of a map mean; none if it shows no numbers.</summary>
internal sealed record LegendMessage(string Map, double Least, double Greatest, IEnumerable<string> Colors) : Message;

/// <summary>The words of the comparison with the user's picture, without the diagnosis.</summary>
/// <param name="HasLayers">Whether frames show the difference.</param>
/// <param name="Middle">A pixel in the middle of what is wrong.</param>
internal sealed record ComparisonMessage(string? Name, string? Problem, string? Text, string? Verdict, bool HasLayers, int[]? Middle) : Message;

internal sealed record DiagnosisMessage(string Text) : Message;

/// <summary>Whether the camera was written into the file.</summary>
/// <param name="Problem">Why not; empty if it was.</param>
internal sealed record WrittenMessage(string Problem) : Message;

/// <summary>The scene's new text, in a page without a server.</summary>
internal sealed record TextMessage(string Text) : Message;

/// <summary>Why a picture was not taken, in a page without a server.</summary>
internal sealed record RefusedMessage(string Name, string Problem) : Message;
