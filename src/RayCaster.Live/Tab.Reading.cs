using System.Net.WebSockets;
using System.Text.Json;

namespace RayCaster.Live;

/// <summary>What a page asks for.</summary>
internal sealed partial class Tab
{
    private const int MostBytes = 1 << 16; // of a message; sensible ones have a hundred

    private async Task ReadAsync()
    {
        var bytes = new byte[MostBytes];
        while (true)
        {
            var length = 0;
            while (true)
            {
                var part = await socket.ReceiveAsync(bytes.AsMemory(length), end.Token);
                if (part.MessageType != WebSocketMessageType.Text) return;
                length += part.Count;
                if (part.EndOfMessage) break;
                if (length == MostBytes) return;
            }
            try
            {
                using var message = JsonDocument.Parse(bytes.AsMemory(0, length));
                foreach (var wish in message.RootElement.EnumerateObject()) Take(wish.Name, wish.Value);
            }
            catch (Exception e) when (e is JsonException or InvalidOperationException or FormatException or IndexOutOfRangeException)
            {
                return; // it is not the page that speaks
            }
            Wake();
        }
    }

    /// <summary>Keeps one wish.</summary>
    private void Take(string name, JsonElement value)
    {
        lock (gate)
        {
            switch (name)
            {
                case "shown":
                    shown = value.GetInt32();
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
                    divisor = Math.Clamp(value.GetInt32(), 1, 8);
                    break;
                case "rest":
                    Rest();
                    break;
                case "camera":
                    SeeThrough(value);
                    break;
                case "hidden":
                    Look(view with { Hidden = string.Join(',', value.EnumerateArray().Select(place => place.GetUInt16())) });
                    break;
                case "look":
                    Look(view with { Look = Enum.Parse<Look>(value[0].GetString()!, ignoreCase: true), Model = value[1].GetInt32() });
                    break;
                case "hover":
                    hover = (value[0].GetInt32(), value[1].GetInt32());
                    break;
                case "explain":
                    explained = value.ValueKind == JsonValueKind.Null ? null : (value[0].GetInt32(), value[1].GetInt32());
                    wantsExplanation = explained is not null;
                    break;
                case "map":
                    map = value.ValueKind == JsonValueKind.Null ? null : MapKinds.Named(value.GetString()!);
                    wantsMap = map is not null;
                    break;
                case "ledger":
                    wantsLedger = true;
                    break;
                case "hint":
                    hint = Enum.Parse<HintLevel>(value.GetString()!, ignoreCase: true);
                    wantsComparison = true;
                    break;
                case "diagnose":
                    wantsDiagnosis = true;
                    wantsComparison = true;
                    break;
                case "forgetMine":
                    server.Mine.Forget();
                    break;
                case "write":
                    WriteCamera(value.GetInt32());
                    break;
                default:
                    throw new FormatException($"there is no wish '{name}'");
            }
        }
    }

    private static double Finite(JsonElement value) => value.GetDouble() is var number && double.IsFinite(number)
        ? number
        : throw new FormatException("a number is not finite");

    /// <summary>Moves the camera by hand; every move is kept, however few frames are drawn.</summary>
    private void Move(Func<Camera, Camera> move)
    {
        if (server.Scene.State.Scene is not { } scene) return;
        view = view with { Camera = move(view.Camera ?? scene.Camera) };
        (isMoving, wantsFrame) = (true, true);
        outdated.Cancel();
    }

    /// <summary>The hand lets go: a sharp picture from where the camera is now.</summary>
    private void Rest()
    {
        if (view.Camera is { } camera) view = view with { Camera = CameraMotion.Rounded(camera) };
        (isMoving, wantsFrame, wantsCamera) = (false, true, true);
        (wantsExplanation, wantsMap) = (explained is not null, map is not null);
    }

    /// <summary>Goes to a camera that the page remembers, or back to the scene's own.</summary>
    private void SeeThrough(JsonElement value)
    {
        var camera = default(Camera);
        if (value.ValueKind != JsonValueKind.Null && server.Scene.State.Scene is { } scene)
        {
            camera = new(scene.Camera.Parameters with
            {
                Position = VectorOf(value.GetProperty("position")),
                Target = VectorOf(value.GetProperty("target")),
            });
        }
        view = view with { Camera = camera?.Flaw is null ? camera : null };
        outdated.Cancel();
        Rest();
    }

    private static Vector3 VectorOf(JsonElement value) => new(Finite(value[0]), Finite(value[1]), Finite(value[2]));

    private void Look(View other)
    {
        view = other;
        wantsFrame = true;
        (wantsExplanation, wantsMap) = (explained is not null, map is not null);
        outdated.Cancel();
    }

    /// <summary>Writes the camera into the scene file, if the page knows what the file says.</summary>
    private void WriteCamera(int version)
    {
        var camera = view.Camera;
        _ = Task.Run(() =>
        {
            try
            {
                Post(Messages.Of(new { Kind = "written", Problem = camera is null ? "" : server.Scene.WriteCamera(camera, version) ?? "" }));
            }
            catch (Exception e) when (e is PictureFileException or IOException or UnauthorizedAccessException)
            {
                Post(Messages.Of(new { Kind = "written", Problem = e.Message }));
            }
        });
    }
}
