using System.Runtime.InteropServices.JavaScript;
using System.Runtime.Versioning;

namespace RayCaster.Web;

/// <summary>What a Web Worker of the page calls (Page/worker.js).</summary>
[SupportedOSPlatform("browser")]
internal static partial class Program
{
    private static readonly MinePicture mine = new(null, default);
    private static LiveScene? live;
    private static Tab? tab;

    private static void Main()
    {
    }

    /// <summary>Begins to answer the page.</summary>
    /// <param name="answers">What this worker answers, as names of <see cref="Pending"/>.</param>
    /// <param name="name">The scene's name, and its text.</param>
    [JSExport]
    internal static Task Start(string answers, string name, string text)
    {
        File.WriteAllText(name, text); // the worker's files are in its memory
        live = new(name, default);
        tab = new(new WorkerConnection(), live, mine, new PatientStudio(), default, Enum.Parse<Pending>(answers));
        live.Changed += tab.Wake;
        mine.Changed += tab.CompareAgain;
        return tab.AnswerAsync();
    }

    /// <summary>Takes a scene that the user has changed or opened.</summary>
    [JSExport]
    internal static void Change(string name, string text)
    {
        File.WriteAllText(name, text);
        live!.ReadAgain(name);
    }

    /// <summary>Sends the text, into which the camera was written.</summary>
    [JSExport]
    internal static void ReadBack() => tab!.Post(Messages.Of(new { Kind = "text", Text = File.ReadAllText(live!.Path) }));

    /// <summary>Takes the requests that a page also sends to RayCaster.Live's server.</summary>
    [JSExport]
    internal static void Ask(string requests) => tab!.Take(Encoding.UTF8.GetBytes(requests));

    /// <summary>Takes a picture of the user's own program.</summary>
    [JSExport]
    internal static void Compare(string file, byte[] bytes)
    {
        try
        {
            mine.Take(file, new MemoryStream(bytes), live!.State.Scene);
        }
        catch (ProblemException problem)
        {
            tab!.Post(Messages.Of(new { Kind = "refused", Name = file, Problem = problem.Message }));
        }
    }
}
