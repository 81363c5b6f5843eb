using System.Collections.Concurrent;
using System.Net.WebSockets;

namespace RayCaster.Live;

/// <summary>
/// One page in a browser. What it asks for is kept, the newest instead of the older; frames go out one after another, and the next only when the
/// page
/// has shown the one before the last: a slow or stopped browser costs nothing.
/// </summary>
internal sealed partial class Tab
{
    private const int MostUnseen = 2;

    private readonly WebSocket socket;
    private readonly LiveServer server;
    private readonly SemaphoreSlim wake = new(1, 1);
    private readonly MovingBuffer buffer = new();
    private readonly CancellationTokenSource end;
    private readonly ConcurrentQueue<byte[]> posted = new();
    private Task sending = Task.CompletedTask;

    private readonly Lock gate = new(); // guards what follows, which the reading loop writes and the sending loop reads
    private View view = new();
    private bool isMoving, wantsFrame, wantsCamera, wantsLedger;
    private int divisor = 1;
    private MapKind? map;
    private bool wantsMap, wantsComparison;
    private (int Column, int Line)? hover, explained;
    private bool wantsExplanation;
    private int shown, sent;
    private SceneState? told; // what the page knows of the scene
    private CancellationTokenSource outdated = new();

    public Tab(WebSocket socket, LiveServer server, CancellationToken cancellation)
    {
        (this.socket, this.server) = (socket, server);
        end = CancellationTokenSource.CreateLinkedTokenSource(cancellation);
    }

    /// <summary>Says that the scene, the code or the picture to compare with has changed.</summary>
    public void Wake()
    {
        lock (wake)
            if (wake.CurrentCount == 0) wake.Release();
    }

    /// <summary>Tells the page something, in its turn.</summary>
    public void Post(byte[] message)
    {
        posted.Enqueue(message);
        Wake();
    }

    /// <summary>Serves the page until it is closed.</summary>
    public async Task RunAsync()
    {
        try
        {
            var reading = ReadAsync();
            await Task.WhenAny(reading, SendAsync());
        }
        finally
        {
            await end.CancelAsync();
            socket.Abort();
        }
    }

    /// <summary>Answers what has been asked for, the quickest first.</summary>
    private async Task SendAsync()
    {
        while (true)
        {
            await wake.WaitAsync(end.Token);
            try
            {
                var state = server.Scene.State;
                await TellSceneAsync(state);
                while (posted.TryDequeue(out var message)) await SendAsync(message);
                if (state.Scene is null) continue;
                await TellHoverAsync(state);
                await TellFrameAsync(state);
                await TellCameraAsync(state);
                await TellExplanationAsync(state);
                await TellMapAsync(state);
                await TellComparisonAsync(state);
                await TellLedgerAsync(state);
            }
            catch (OperationCanceledException) when (!end.IsCancellationRequested)
            {
                Wake(); // the scene or the view has changed meanwhile; what was wanted still is
            }
        }
    }

    private async Task TellSceneAsync(SceneState state)
    {
        if (ReferenceEquals(told, state)) return;
        await SendAsync(Messages.OfScene(server.Scene, state));
        var isOther = !ReferenceEquals(told?.Scene, state.Scene) || told?.Version != state.Version;
        lock (gate)
        {
            // Whoever writes another camera into the file wants to see through it.
            if (state.IsGood && told?.Scene is { } before && !IsSame(before.Camera, state.Scene!.Camera)) view = view with { Camera = null };
            told = state;
            if (!state.IsGood || !isOther) return;
            wantsFrame = wantsCamera = true;
            wantsExplanation = explained is not null;
            wantsMap = map is not null;
            wantsComparison = true;
        }
    }

    private async Task TellFrameAsync(SceneState state)
    {
        View wanted;
        bool moves;
        lock (gate)
        {
            if (!wantsFrame || sent - shown >= MostUnseen) return;
            (wantsFrame, moves) = (false, isMoving);
            wanted = moves ? view with { Divisor = divisor } : view;
        }
        try
        {
            var frame = moves
                ? await server.Studio.DrawAsync(wanted.Of(state.Scene!), buffer, end.Token)
                : await server.Studio.DrawAsync(state, wanted, Outdated());
            await SendFrameAsync(frame, Layer.Picture, state.Version, !moves);
            server.FirstPictureSent(state.Scene!);
        }
        catch (OperationCanceledException)
        {
            lock (gate) wantsFrame = true;
            throw;
        }
    }

    private async Task TellCameraAsync(SceneState state)
    {
        Camera? camera;
        lock (gate)
        {
            if (!wantsCamera) return;
            (wantsCamera, camera) = (false, view.Camera);
        }
        await SendAsync(Messages.OfCamera(camera ?? state.Scene!.Camera, camera is not null));
    }

    private async Task TellHoverAsync(SceneState state)
    {
        (int Column, int Line) place;
        lock (gate)
        {
            if (hover is not { } wanted) return;
            (hover, place) = (null, wanted);
        }
        var scene = view.Of(state.Scene!);
        if (IsIn(scene, place)) await SendAsync(Messages.OfHover(scene, place.Column, place.Line));
    }

    private async Task TellExplanationAsync(SceneState state)
    {
        (int Column, int Line) place;
        View seen;
        lock (gate)
        {
            if (!wantsExplanation || isMoving || explained is not { } wanted) return;
            (wantsExplanation, place, seen) = (false, wanted, view);
        }
        var scene = seen.Of(state.Scene!);
        if (!IsIn(scene, place)) return;
        var mine = seen.Camera is null ? server.Mine.PictureFor(scene.Camera) : null;
        await SendAsync(await Task.Run(() => Messages.OfExplanation(scene, place.Column, place.Line, mine, state.Version)));
    }

    private async Task TellLedgerAsync(SceneState state)
    {
        View seen;
        lock (gate)
        {
            if (!wantsLedger || isMoving) return;
            (wantsLedger, seen) = (false, view);
        }
        var scene = seen.Of(state.Scene!);
        var ledger = await Task.Run(() => HitLedger.Take(scene, Outdated()));
        await SendAsync(Messages.OfLedger(ledger, state.Version));
    }

    /// <summary>Cancelled when the scene says something else, the page looks elsewhere, or is closed.</summary>
    private CancellationToken Outdated()
    {
        lock (gate)
        {
            outdated.Dispose(); // what it was for is done; kept, each would stay registered with the end of the page
            outdated = CancellationTokenSource.CreateLinkedTokenSource(server.Scene.Outdated, end.Token);
            return outdated.Token;
        }
    }

    /// <summary>A frame goes out while the next is drawn, which another thread does.</summary>
    private async Task SendFrameAsync(Frame frame, Layer layer, int version, bool isFinal)
    {
        await sending;
        var number = layer == Layer.Picture ? Interlocked.Increment(ref sent) : 0;
        sending = SendAsync(frame.Header(layer, version, number, isFinal), frame);
    }

    private async Task SendAsync(byte[] header, Frame frame)
    {
        await socket.SendAsync(header.AsMemory(), WebSocketMessageType.Binary, false, end.Token);
        await socket.SendAsync(frame.Pixels, WebSocketMessageType.Binary, true, end.Token);
    }

    private async Task SendAsync(byte[] message)
    {
        await sending;
        sending = socket.SendAsync(message.AsMemory(), WebSocketMessageType.Text, true, end.Token).AsTask();
    }

    private static bool IsIn(Scene scene, (int Column, int Line) place) =>
        place.Column >= 0 && place.Line >= 0 && place.Column < scene.Camera.Width && place.Line < scene.Camera.Height;

    private static bool IsSame(Camera a, Camera b) => (a.Position, a.Target, a.Up, a.FovY) == (b.Position, b.Target, b.Up, b.FovY);
}
