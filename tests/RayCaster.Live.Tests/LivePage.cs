using System.Net.WebSockets;
using System.Runtime.InteropServices;
using System.Text.Json;
using Microsoft.Extensions.Time.Testing;

namespace RayCaster.Live.Tests;

/// <summary>A server for a scene in a folder of its own, and a page's connection to it without a browser.</summary>
internal sealed class LivePage : IAsyncDisposable
{
    public const string Ball = """
        {
          // a ball
          "camera": { "position": [6, 0, 2.5], "target": [-6, 0, 0], "width": 40, "height": 30 },
          "models": [ { "type": "sphere", "name": "ball", "center": [0, 0, 1], "radius": 1, "color": [1, 0.5, 0.1] } ]
        }
        """;

    private readonly Queue<string> received = []; // what came last, for the message of a test that waits in vain
    private ClientWebSocket? socket;

    private LivePage(TemporaryFolder folder, LiveServer server, FakeTimeProvider? clock) => (Folder, Server, Clock) = (folder, server, clock);

    /// <summary>By which the server follows its files: it goes on only while the test waits for a message. Null for the system's.</summary>
    public FakeTimeProvider? Clock { get; }

    public LiveServer Server { get; }

    public TemporaryFolder Folder { get; }

    public string Scene => Folder["scene.json"];

    public string Root => $"http://127.0.0.1:{Server.Port}";

    public string Token => Server.Address[(Server.Address.IndexOf('=') + 1)..];

    public static async Task<LivePage> OpenAsync(
        string scene = Ball, string? mine = null, Action<TemporaryFolder>? prepare = null, FakeTimeProvider? clock = null)
    {
        var folder = new TemporaryFolder();
        prepare?.Invoke(folder);
        var path = folder.Write("scene.json", scene);
        return new(folder, await LiveServer.StartAsync(path, mine is null ? null : folder[mine], clock: clock), clock);
    }

    /// <summary>A page that has shown its first picture.</summary>
    public static async Task<LivePage> ShownAsync(string scene = Ball, string? mine = null, Action<TemporaryFolder>? prepare = null)
    {
        var page = await OpenAsync(scene, mine, prepare, new(DateTimeOffset.UtcNow));
        await page.ConnectAsync();
        await page.FrameAsync();
        return page;
    }

    /// <summary>Connects to the server as the page does.</summary>
    public async Task ConnectAsync(string? origin = null, string? token = null)
    {
        socket = new();
        socket.Options.SetRequestHeader("Origin", origin ?? Root);
        socket.Options.AddSubProtocol(token ?? Token);
        await socket.ConnectAsync(new($"ws://127.0.0.1:{Server.Port}/live"), new CancellationTokenSource(TimeSpan.FromSeconds(60)).Token);
    }

    public Task AskAsync(string requests) =>
        socket!.SendAsync(Encoding.UTF8.GetBytes(requests), WebSocketMessageType.Text, true, CancellationToken.None);

    /// <summary>The next message of a kind that suits. Confirms frames that come before it, and drops other messages.</summary>
    public async Task<JsonElement> MessageAsync(string kind, Func<JsonElement, bool>? suits = null)
    {
        while (true)
        {
            var (isText, bytes) = await NextAsync();
            if (!isText) continue;
            var message = JsonDocument.Parse(bytes).RootElement;
            if (message.GetProperty("kind").GetString() == kind && suits?.Invoke(message) != false) return message;
        }
    }

    /// <summary>The next frame of full size.</summary>
    public async Task<SeenFrame> FrameAsync(Layer layer = Layer.Picture)
    {
        while (true)
        {
            var (isText, bytes) = await NextAsync();
            if (isText) continue;
            int Number(int i) => BitConverter.ToInt32(bytes, 4 * i);
            if (Number(0) == (int)layer && Number(3) == 1) return new(Number(1), Number(4), Number(5), bytes[24..]);
        }
    }

    public async ValueTask DisposeAsync()
    {
        socket?.Abort();
        await Server.DisposeAsync();
        Folder.Dispose();
    }

    private async Task<(bool IsText, byte[] Bytes)> NextAsync()
    {
        using var whole = new MemoryStream();
        var part = new byte[1 << 16];
        while (true)
        {
            var result = await ReceiveAsync(part);
            whole.Write(part, 0, result.Count);
            if (!result.EndOfMessage) continue;
            if (result.MessageType == WebSocketMessageType.Close) throw new InvalidOperationException("the server has closed the connection");
            var bytes = whole.ToArray();
            received.Enqueue(result.MessageType == WebSocketMessageType.Text ? Encoding.UTF8.GetString(bytes)
                : $"a frame: {string.Join(' ', MemoryMarshal.Cast<byte, int>(bytes)[..6].ToArray())}");
            if (received.Count > 8) received.Dequeue();
            if (result.MessageType == WebSocketMessageType.Binary && bytes[0] == (int)Layer.Picture)
                await AskAsync($$"""{"shown":{{BitConverter.ToInt32(bytes, 8)}}}""");
            return (result.MessageType == WebSocketMessageType.Text, bytes);
        }
    }

    /// <remarks>Counts how often it has waited, since the time of a virtual machine jumps when it is resumed.</remarks>
    private async Task<WebSocketReceiveResult> ReceiveAsync(byte[] part)
    {
        var receiving = socket!.ReceiveAsync(part, CancellationToken.None);
        for (var i = 0; i < 30_000 && !receiving.IsCompleted; i++)
        {
            await Task.WhenAny(receiving, Task.Delay(2));
            Clock?.Advance(TimeSpan.FromMilliseconds(10));
        }
        if (receiving.IsCompleted) return await receiving;
        var (state, file) = (Server.Scene.State, FileWatch.StampOf(Scene));
        throw new TimeoutException("Nothing came in 30,000 waits of 2 ms or more, and of 10 ms by the server's clock. The server's scene has " +
            $"version {state.Version}, the file {file.Length} bytes of {file.Time:T}; the pool has {ThreadPool.ThreadCount} threads and " +
            $"{ThreadPool.PendingWorkItemCount} waiting. The last messages:\n" +
            string.Join('\n', received.Select(message => message[..Math.Min(300, message.Length)])));
    }
}

/// <summary>A frame as the page receives it.</summary>
internal sealed record SeenFrame(int Version, int Width, int Height, byte[] Rgba)
{
    public (byte R, byte G, byte B) this[int x, int y] => (Rgba[4 * (y * Width + x)], Rgba[4 * (y * Width + x) + 1], Rgba[4 * (y * Width + x) + 2]);

    public void IsThatOf(string scene)
    {
        var right = ScalarRenderer.Render(SceneReader.Read(scene).Scene!);
        Assert.Equal((right.Width, right.Height), (Width, Height));
        for (var y = 0; y < Height; y++)
            for (var x = 0; x < Width; x++)
                Assert.Equal(right[x, y], this[x, y]);
    }
}
