using System.Collections.Concurrent;
using System.Threading.Channels;

namespace RayCaster.Page;

/// <summary>
/// The connection to one page in a browser. Of each kind of request only the newest is kept, and a frame is sent only after the page has shown the
/// one before the last, so a slow or stopped browser costs nothing.
/// </summary>
/// <param name="answers">What the page wants to receive from here.</param>
internal sealed partial class PageSession(
    IConnection connection, LiveScene live, UserPicture mine, RenderQueue queue, CancellationToken end, MessageKind answers = MessageKind.All)
{
    private const int MaxUnseen = 2;

    private readonly Channel<bool> wake = Channel.CreateBounded<bool>(new BoundedChannelOptions(1) { FullMode = BoundedChannelFullMode.DropWrite });
    private readonly ConcurrentQueue<Message> posted = new();
    private Task sending = Task.CompletedTask;
    private bool hasFault; // the page shows a fault of the code
    private Comparison? compared; // the comparison that the page knows
    private int sent; // frames

    private readonly Lock sync = new(); // for the fields below
    private MessageKind pending;
    private Wishes wishes = new(new(), new());
    private SceneState? known; // the state that the page knows
    private CancellationTokenSource outdated = new();

    /// <summary>A pixel of the picture that the page shows, from the left and from the top.</summary>
    private sealed record Place(int Column, int Line);

    /// <summary>What the page has last requested. The reading loop replaces it as a whole, so the sending loop needs no lock to read it.</summary>
    /// <param name="Diagnosing">Cancelled by "Cancel", which may come before the diagnosis begins.</param>
    /// <param name="Shown">How many frames the page has shown.</param>
    private sealed record Wishes(
        View View, CancellationTokenSource Diagnosing, bool Diagnoses = false, HintLevel Hint = HintLevel.Question, bool IsMoving = false,
        int Divisor = 1, MapKind? Map = null, Place? Hover = null, Place? Explained = null, int Shown = 0);

    public void Wake() => wake.Writer.TryWrite(true);

    public void Post(Message message)
    {
        posted.Enqueue(message);
        Wake();
    }

    public void CompareAgain()
    {
        lock (sync) pending |= MessageKind.Comparison | MessageKind.Explanation;
        Wake();
    }

    /// <summary>What answers each kind of request, the quickest first.</summary>
    private (MessageKind Kind, Func<SceneState, Wishes, Task> Answer)[] Answers => field ??=
    [
        (MessageKind.Hover, async (state, now) =>
        {
            var scene = now.View.Of(state.Scene!);
            if (now.Hover is { } place && IsIn(scene, place)) await SendAsync(Messages.OfHover(scene, place.Column, place.Line));
        }),
        (MessageKind.Frame, SendPictureAsync),
        (MessageKind.Camera, (state, now) =>
            SendAsync(Messages.OfCamera(now.View.Camera ?? state.Scene!.Camera, now.View.Camera is not null))),
        (MessageKind.Explanation, async (state, now) =>
        {
            var scene = now.View.Of(state.Scene!);
            if (now.Explained is not { } place || !IsIn(scene, place)) return;
            var reference = now.View.Camera is null ? mine.PictureFor(scene.Camera) : null;
            await SendAsync(await Task.Run(() => Messages.OfExplanation(scene, place.Column, place.Line, reference)));
        }),
        (MessageKind.Map, async (state, now) =>
        {
            if (now.Map is not { } kind) return;
            var map = await queue.DoAsync(() => MapPicture.Draw(now.View.Of(state.Scene!), kind), Outdated());
            await SendAsync(Messages.OfLegend(map, kind));
            await SendFrameAsync(CanvasImage.Of(map.Picture), Layer.Map, state.Version, isFinal: true);
        }),
        (MessageKind.Comparison | MessageKind.Diagnosis, SendComparisonAsync),
        (MessageKind.Ledger, async (state, now) =>
        {
            var scene = now.View.Of(state.Scene!);
            await SendAsync(Messages.OfLedger(scene, await Task.Run(() => SceneVisibility.Take(scene, Outdated()))));
        }),
    ];

    public async Task AnswerAsync()
    {
        Wake();
        await foreach (var _ in wake.Reader.ReadAllAsync(end))
        {
            try
            {
                var state = live.State;
                await SendSceneAsync(state);
                while (posted.TryDequeue(out var message)) await SendAsync(message);
                if (state.Scene is null) continue;
                foreach (var (kind, answer) in Answers)
                    if (Take(kind) is { } now)
                        await answer(state, now);
            }
            catch (OperationCanceledException) when (!end.IsCancellationRequested)
            {
                // The scene or the view has changed during the work.
                lock (sync) Refresh();
                Wake();
            }
            catch (Exception fault) when (!end.IsCancellationRequested)
            {
                // Often a formula that was changed. The page shows the fault until a picture is drawn again.
                hasFault = true;
                await SendAsync(new FaultMessage(Fault.InWords("raycaster-live", fault)));
            }
        }
    }

    private async Task SendSceneAsync(SceneState state)
    {
        if (ReferenceEquals(known, state)) return;
        if (answers.HasFlag(MessageKind.Scene)) await SendAsync(Messages.OfScene(live, state));
        lock (sync)
        {
            // After a change of the camera in the file the page shows the file's camera, not the one that was turned.
            if (state.IsGood && known?.Scene is { } before && !IsSame(before.Camera, state.Scene!.Camera)) See(null);
            known = state;
            if (!state.IsGood) return;
            Refresh();
            pending |= MessageKind.Camera | MessageKind.Comparison;
        }
    }

    /// <summary>Notes that the page needs again everything that depends on the scene and the view.</summary>
    private void Refresh() => pending |= MessageKind.Frame | MessageKind.Explanation | MessageKind.Map | MessageKind.Ledger;

    /// <summary>What the page wishes, if something of a kind is to be sent now; from then on it is not, unless it is requested again.</summary>
    private Wishes? Take(MessageKind kinds)
    {
        lock (sync)
        {
            var mustWait = wishes.IsMoving && (kinds & (MessageKind.Explanation | MessageKind.Map | MessageKind.Ledger)) != 0
                || kinds == MessageKind.Frame && sent - wishes.Shown >= MaxUnseen;
            var taken = pending & answers & kinds;
            if (mustWait || taken == 0) return null;
            pending &= ~kinds;
            return wishes with { Diagnoses = taken.HasFlag(MessageKind.Diagnosis) };
        }
    }

    private async Task SendPictureAsync(SceneState state, Wishes now)
    {
        var view = now.IsMoving ? now.View with { Divisor = now.Divisor } : now.View;
        var frame = await queue.DrawAsync(state.Scene!, view, now.IsMoving ? end : Outdated());
        await SendFrameAsync(frame, Layer.Picture, state.Version, !now.IsMoving);
        if (hasFault) await SendAsync(new FaultMessage(null));
        hasFault = false;
    }

    private async Task SendComparisonAsync(SceneState state, Wishes now)
    {
        var comparison = mine.CompareWith(state, live.Path);
        if (!ReferenceEquals(comparison, compared))
        {
            if (!now.Diagnoses) await now.Diagnosing.CancelAsync();
            compared = comparison;
            if (answers.HasFlag(MessageKind.Comparison)) await SendAsync(comparison, state.Version);
        }
        if (now.Diagnoses) _ = SendDiagnosisAsync(comparison, now.Hint, now.Diagnosing.Token);
    }

    private async Task SendAsync(Comparison comparison, int version)
    {
        foreach (var (layer, frame) in comparison.Frames()) await SendFrameAsync(frame, layer, version, isFinal: true);
        await SendAsync(await queue.DoAsync(comparison.Message, end));
        if (comparison.ByObject() is { } byObject) await SendFrameAsync(byObject, Layer.ByObject, version, isFinal: true);
    }

    /// <summary>Sends the diagnosis later: it takes seconds, in which the page can be used.</summary>
    private async Task SendDiagnosisAsync(Comparison comparison, HintLevel level, CancellationToken cancellation)
    {
        string text;
        try
        {
            text = await comparison.DiagnoseAsync(level, queue.SearchTime, cancellation);
        }
        catch (Exception) when (cancellation.IsCancellationRequested)
        {
            text = "The diagnosis was cancelled.";
        }
        catch (Exception fault)
        {
            text = Fault.InWords("raycaster-live", fault);
        }
        if (ReferenceEquals(comparison, compared)) Post(new DiagnosisMessage(text));
    }

    /// <summary>Cancelled when the scene or the view changes, or the page closes.</summary>
    private CancellationToken Outdated()
    {
        lock (sync)
        {
            outdated.Dispose(); // its work is done; without this each would stay registered until the page closes
            outdated = CancellationTokenSource.CreateLinkedTokenSource(live.Outdated, end);
            return outdated.Token;
        }
    }

    /// <summary>Starts to send a frame; the next one is drawn at the same time.</summary>
    private async Task SendFrameAsync(CanvasImage frame, Layer layer, int version, bool isFinal)
    {
        await sending;
        if (layer == Layer.Picture) sent++;
        sending = connection.SendAsync(frame.Header(layer, version, sent, isFinal), frame, end);
    }

    private async Task SendAsync(Message message)
    {
        await sending;
        sending = connection.SendAsync(message.ToJson(), end);
    }

    private static bool IsIn(Scene scene, Place place) =>
        place.Column >= 0 && place.Line >= 0 && place.Column < scene.Camera.Width && place.Line < scene.Camera.Height;

    private static bool IsSame(Camera a, Camera b) => (a.Position, a.Target, a.Up, a.FovY) == (b.Position, b.Target, b.Up, b.FovY);
}
