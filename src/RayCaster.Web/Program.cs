using System.Runtime.InteropServices.JavaScript;

namespace RayCaster.Web;

/// <summary>What a Web Worker of the page calls (Page/worker.js), and how it is called.</summary>
internal sealed partial class Program : IConnection
{
    private static readonly UserPicture mine = new(null, TimeProvider.System, default);
    private static LiveScene? live;
    private static PageSession? session;

    private static void Main() { } // the worker calls the methods below

    /// <param name="answers">What this worker answers, as names of <see cref="MessageKind"/>.</param>
    /// <param name="name">The scene's name, and its text.</param>
    [JSExport]
    internal static Task Start(string answers, string name, string text)
    {
        File.WriteAllText(name, text); // the worker's files are in its memory
        live = new(name, TimeProvider.System, default);
        session = new(new Program(), live, mine, new ChunkedRenderQueue(), default, Enum.Parse<MessageKind>(answers));
        live.Changed += session.Wake;
        live.Written += () => session.Post(new TextMessage(File.ReadAllText(live.Path)));
        mine.Changed += session.CompareAgain;
        return session.AnswerAsync();
    }

    [JSExport]
    internal static void Change(string name, string text)
    {
        File.WriteAllText(name, text);
        live!.ReadAgain(name);
    }

    /// <summary>Takes the requests that a page also sends to RayCaster.Live's server.</summary>
    [JSExport]
    internal static void Ask(string requests) => session!.Take(Encoding.UTF8.GetBytes(requests));

    [JSExport]
    internal static void Compare(string file, byte[] bytes)
    {
        try
        {
            mine.Take(file, new MemoryStream(bytes), live!.State.Scene);
        }
        catch (ProblemException problem)
        {
            session!.Post(new RefusedMessage(file, problem.Message));
        }
    }

    public Task SendAsync(byte[] message, CancellationToken cancellation)
    {
        Post(Encoding.UTF8.GetString(message));
        return Task.CompletedTask;
    }

    public Task SendAsync(byte[] header, CanvasImage frame, CancellationToken cancellation)
    {
        PostFrame(header, frame.Pixels.Span);
        return Task.CompletedTask;
    }

    [JSImport("post", "worker")]
    private static partial void Post(string message);

    [JSImport("postFrame", "worker")]
    private static partial void PostFrame([JSMarshalAs<JSType.MemoryView>] Span<byte> header, [JSMarshalAs<JSType.MemoryView>] Span<byte> pixels);
}
