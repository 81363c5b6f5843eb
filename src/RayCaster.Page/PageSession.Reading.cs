using System.Text.Json;

namespace RayCaster.Page;

/// <summary>Receives the page's requests.</summary>
internal sealed partial class PageSession
{
    /// <summary>Takes a message of requests.</summary>
    /// <returns>False if the page sends no such message: another program does.</returns>
    public bool Take(ReadOnlyMemory<byte> requests)
    {
        try
        {
            using var message = JsonDocument.Parse(requests);
            foreach (var request in message.RootElement.EnumerateObject()) Take(request.Name, request.Value);
        }
        catch (Exception e) when (e is JsonException or InvalidOperationException or FormatException or IndexOutOfRangeException)
        {
            return false;
        }
        Wake();
        return true;
    }

    private void Take(string name, JsonElement value)
    {
        lock (sync)
        {
            switch (name)
            {
                case "shown":
                    wishes = wishes with { Shown = value.GetInt32() };
                    break;
                case "turn":
                    Move(camera => CameraMotion.Turn(camera, Finite(value[0]), Finite(value[1])));
                    break;
                case "approach":
                    Move(camera => CameraMotion.Approach(camera, Math.Clamp(Finite(value), 0.01, 100)));
                    break;
                case "shift":
                    Move(camera => CameraMotion.Shift(camera, Finite(value[0]), Finite(value[1])));
                    break;
                case "divisor":
                    wishes = wishes with { Divisor = Math.Clamp(value.GetInt32(), 1, 8) };
                    break;
                case "rest":
                    Rest();
                    break;
                case "camera":
                    SeeThrough(value);
                    break;
                case "hover":
                    wishes = wishes with { Hover = new(value[0].GetInt32(), value[1].GetInt32()) };
                    pending |= MessageKind.Hover;
                    break;
                case "explain":
                    wishes = wishes with { Explained = IsNull(value) ? null : new(value[0].GetInt32(), value[1].GetInt32()) };
                    pending |= MessageKind.Explanation;
                    break;
                case "map":
                    MapKind? map = IsNull(value) ? null : MapKinds.Named(value.GetString()!) ?? throw new FormatException("there is no such map");
                    wishes = wishes with { Map = map };
                    pending |= MessageKind.Map;
                    break;
                case "hint":
                    wishes = wishes with { Hint = Named<HintLevel>(value) };
                    break;
                case "diagnose":
                    wishes.Diagnosing.Cancel(); // if it has not begun, it begins and is told to be cancelled
                    if (!value.GetBoolean()) break;
                    wishes = wishes with { Diagnosing = CancellationTokenSource.CreateLinkedTokenSource(end) };
                    pending |= MessageKind.Diagnosis;
                    break;
                case "forgetMine":
                    mine.Forget();
                    break;
                case "write":
                    if (answers.HasFlag(MessageKind.Camera)) WriteCamera(value.GetInt32());
                    break;
                default:
                    throw new FormatException($"there is no request '{name}'");
            }
        }
    }

    private static bool IsNull(JsonElement value) => value.ValueKind == JsonValueKind.Null;

    /// <summary>The member of an enumeration that a request names; numbers are no names.</summary>
    private static T Named<T>(JsonElement value) where T : struct, Enum =>
        Enum.GetValues<T>().First(member => string.Equals($"{member}", value.GetString(), StringComparison.OrdinalIgnoreCase));

    private static double Finite(JsonElement value)
    {
        var number = value.GetDouble();
        return double.IsFinite(number) ? number : throw new FormatException("a number is not finite");
    }

    /// <summary>Moves the camera. Each move counts, even if no frame is drawn before the next.</summary>
    private void Move(Func<Camera, Camera> move)
    {
        if (live.State.Scene is not { } scene) return;
        See(move(wishes.View.Camera ?? scene.Camera));
        wishes = wishes with { IsMoving = true };
        pending |= MessageKind.Frame;
        outdated.Cancel();
    }

    /// <summary>Ends a movement: the next frame has its full size.</summary>
    private void Rest()
    {
        if (wishes.View.Camera is { } camera) See(CameraMotion.Rounded(camera));
        wishes = wishes with { IsMoving = false };
        pending |= MessageKind.Camera;
        Refresh();
    }

    /// <summary>Restores a camera that the page remembers, or with null the scene's own.</summary>
    private void SeeThrough(JsonElement value)
    {
        var camera = IsNull(value) || live.State.Scene is not { } scene ? null : scene.Camera with
        {
            Position = VectorOf(value.GetProperty("position")),
            Target = VectorOf(value.GetProperty("target")),
        };
        See(camera?.ValidationError is null ? camera : null);
        outdated.Cancel();
        Rest();
    }

    /// <param name="camera">The camera that the page has moved; null for the scene's own.</param>
    private void See(Camera? camera) => wishes = wishes with { View = wishes.View with { Camera = camera } };

    private static Vector3 VectorOf(JsonElement value) => new(Finite(value[0]), Finite(value[1]), Finite(value[2]));

    /// <summary>Writes the camera into the scene file, unless the file has changed since the version that the page knows.</summary>
    private void WriteCamera(int version)
    {
        var camera = wishes.View.Camera;
        _ = Task.Run(() => Post(new WrittenMessage(Write())));

        string Write()
        {
            try
            {
                return camera is null ? "" : live.WriteCamera(camera, version) ?? "";
            }
            catch (Exception e) when (e is ProblemException || ProblemException.IsCausedByFile(e))
            {
                return e.Message;
            }
        }
    }
}
