using System.Collections.Concurrent;
using System.Threading.Channels;

namespace RayCaster.Page;

/// <summary>
/// The connection to one page in a browser. Of each kind of request only the newest is kept, and a frame is sent only after the page has shown the
/// one before the last, so a slow or stopped browser costs nothing.
/// </summary>
/// <param name="answers">What the page wants to receive from here.</param>
internal sealed partial class Tab(
    IConnection connection, LiveScene live, MinePicture mine, Studio studio, CancellationToken end, MessageKind answers = MessageKind.All)
{
    private const int MaxUnseen = 2;

    private readonly Channel<bool> wake = Channel.CreateBounded<bool>(new BoundedChannelOptions(1) { FullMode = BoundedChannelFullMode.DropWrite });
    private readonly ConcurrentQueue<byte[]> posted = new();
    private Task sending = Task.CompletedTask;
    private bool hasFault; // the page shows a fault of the code
    private Comparison? compared; // the comparison that the page knows
    private int sent; // frames

    private readonly Lock sync = new(); // for the fields below
    private MessageKind pending;
    private Wishes wishes = new();
    private SceneState? known; // the state that the page knows
    private CancellationTokenSource outdated = new(), diagnosing = new();

    /// <summary>A pixel of the picture that the page shows, from the left and from the top.</summary>
    private sealed record Place(int Column, int Line);

    /// <summary>What the page has last requested. The reading loop replaces it as a whole, so the sending loop needs no lock to read it.</summary>
    /// <param name="Shown">How many frames the page has shown.</param>
    private sealed record Wishes(View View, bool IsMoving, int Divisor, MapKind? Map, Place? Hover, Place? Explained, HintLevel Hint, int Shown)
    {
        public Wishes() : this(new(), false, 1, null, null, null, HintLevel.Question, 0) { }
    }

    public void Wake() => wake.Writer.TryWrite(true);

    public void Post(byte[] message)
    {
        posted.Enqueue(message);
        Wake();
    }

    /// <summary>Compares with the user's picture as it is now.</summary>
    public void CompareAgain()
    {
        lock (sync) pending |= MessageKind.Comparison | MessageKind.Explanation;
        Wake();
    }

    /// <summary>Answers the requests, the quickest first, until the page cannot be reached.</summary>
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
                await SendHoverAsync(state);
                await SendPictureAsync(state);
                await SendCameraAsync(state);
                await SendExplanationAsync(state);
                await SendMapAsync(state);
                await SendComparisonAsync(state);
                await SendLedgerAsync(state);
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
                await SendAsync(Messages.OfFault(Fault.InWords("raycaster-live", fault)));
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

    /// <summary>Whether something is still to be sent; from now on it is not, unless it is requested again.</summary>
    private bool Takes(MessageKind message)
    {
        lock (sync)
        {
            var isPending = (pending & answers).HasFlag(message);
            pending &= ~message;
            return isPending;
        }
    }

    private async Task SendPictureAsync(SceneState state)
    {
        if (sent - wishes.Shown >= MaxUnseen || !Takes(MessageKind.Frame)) return;
        var now = wishes;
        var view = now.IsMoving ? now.View with { Divisor = now.Divisor } : now.View;
        var frame = await studio.DrawAsync(state.Scene!, view, now.IsMoving ? end : Outdated());
        await SendFrameAsync(frame, Layer.Picture, state.Version, !now.IsMoving);
        if (hasFault) await SendAsync(Messages.OfFault(null));
        hasFault = false;
    }

    private async Task SendCameraAsync(SceneState state)
    {
        if (!Takes(MessageKind.Camera)) return;
        var camera = wishes.View.Camera;
        await SendAsync(Messages.OfCamera(camera ?? state.Scene!.Camera, camera is not null));
    }

    private async Task SendHoverAsync(SceneState state)
    {
        if (!Takes(MessageKind.Hover) || wishes is not { Hover: { } place } now) return;
        var scene = now.View.Of(state.Scene!);
        if (IsIn(scene, place)) await SendAsync(Messages.OfHover(scene, place.Column, place.Line));
    }

    private async Task SendExplanationAsync(SceneState state)
    {
        if (wishes.IsMoving || !Takes(MessageKind.Explanation) || wishes is not { Explained: { } place, View: var seen }) return;
        if (!IsIn(seen.Of(state.Scene!), place)) return;
        await SendAsync(await Task.Run(() =>
        {
            var scene = seen.Of(state.Scene!);
            var reference = seen.Camera is null ? mine.PictureFor(scene.Camera) : null;
            return Messages.OfExplanation(scene, place.Column, place.Line, reference);
        }));
    }

    private async Task SendMapAsync(SceneState state)
    {
        if (wishes.IsMoving || !Takes(MessageKind.Map) || wishes is not { Map: { } kind } now) return;
        var scene = now.View.Of(state.Scene!);
        var (legend, frame) = await studio.DoAsync(() => MapDrawing.Of(scene, kind), Outdated());
        await SendAsync(legend);
        await SendFrameAsync(frame, Layer.Map, state.Version, isFinal: true);
    }

    private async Task SendComparisonAsync(SceneState state)
    {
        bool diagnoses;
        CancellationTokenSource diagnosis;
        lock (sync) (diagnoses, diagnosis) = (Takes(MessageKind.Diagnosis), diagnosing); // "Cancel" may come before the diagnosis begins
        if (!Takes(MessageKind.Comparison) && !diagnoses) return;
        var comparison = mine.CompareWith(state, live.Path);
        if (!ReferenceEquals(comparison, compared))
        {
            if (!diagnoses) diagnosis.Cancel();
            compared = comparison;
            if (answers.HasFlag(MessageKind.Comparison)) await SendAsync(comparison, state.Version);
        }
        if (diagnoses) _ = SendDiagnosisAsync(comparison, wishes.Hint, diagnosis.Token);
    }

    private async Task SendAsync(Comparison comparison, int version)
    {
        foreach (var (layer, frame) in comparison.Frames()) await SendFrameAsync(frame, layer, version, isFinal: true);
        await SendAsync(await studio.DoAsync(comparison.Message, end));
        if (comparison.ByObject() is { } byObject) await SendFrameAsync(byObject, Layer.ByObject, version, isFinal: true);
    }

    /// <summary>Sends the diagnosis later: it takes seconds, in which the page can be used.</summary>
    private async Task SendDiagnosisAsync(Comparison comparison, HintLevel level, CancellationToken cancellation)
    {
        string text;
        try
        {
            text = await comparison.DiagnoseAsync(level, studio.SearchTime, cancellation);
        }
        catch (Exception) when (cancellation.IsCancellationRequested)
        {
            text = "The diagnosis was cancelled.";
        }
        catch (Exception fault)
        {
            text = Fault.InWords("raycaster-live", fault);
        }
        if (ReferenceEquals(comparison, compared)) Post(Messages.Of(new { Kind = "diagnosis", Text = text }));
    }

    private async Task SendLedgerAsync(SceneState state)
    {
        if (wishes.IsMoving || !Takes(MessageKind.Ledger)) return;
        var scene = wishes.View.Of(state.Scene!);
        var ledger = await Task.Run(() => SceneVisibility.Take(scene, Outdated()));
        await SendAsync(Messages.OfLedger(scene, ledger));
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

    private async Task SendAsync(byte[] message)
    {
        await sending;
        sending = connection.SendAsync(message, end);
    }

    private static bool IsIn(Scene scene, Place place) =>
        place.Column >= 0 && place.Line >= 0 && place.Column < scene.Camera.Width && place.Line < scene.Camera.Height;

    private static bool IsSame(Camera a, Camera b) => (a.Position, a.Target, a.Up, a.FovY) == (b.Position, b.Target, b.Up, b.FovY);
}
