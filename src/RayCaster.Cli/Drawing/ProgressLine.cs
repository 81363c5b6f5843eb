namespace RayCaster.Cli;

/// <summary>
/// A progress line on the terminal: drawn only if the work takes long, at most ten times a second, and wiped at the end. Any thread may use it.
/// </summary>
/// <param name="what">What is counted.</param>
internal sealed class ProgressLine(TextWriter output, string what, TimeProvider clock) : IDisposable
{
    private const int MaxLength = 79; // a character in the last column of a usual terminal would wrap the line

    private static ProgressLine? seen;

    private readonly long start = clock.GetTimestamp();
    private readonly Lock drawing = new();
    private TimeSpan due = TimeSpan.FromSeconds(0.5);
    private int linesDone, drawn;
    private bool isGone;

    public static ProgressLine? For(CommandLine line, string what = "lines")
    {
        var isSeen = !Console.IsErrorRedirected && Environment.GetEnvironmentVariable("TERM") != "dumb"
            && string.IsNullOrEmpty(Environment.GetEnvironmentVariable("CI"));
        return line.Get(Option.Quiet) || !isSeen ? null : seen = new(Console.Error, what, TimeProvider.System);
    }

    public static void Wipe() => seen?.Dispose();

    public void LinesDone(int lines, int height) => Show(Interlocked.Add(ref linesDone, lines), height);

    /// <summary>Shows how many are done of all, and the time that is left.</summary>
    /// <param name="now">What is being done; empty if that needs no name.</param>
    public void Show(int done, int all, string now = "")
    {
        lock (drawing)
        {
            var elapsed = clock.GetElapsedTime(start);
            if (done == 0 || elapsed < due) return;
            due = elapsed + TimeSpan.FromSeconds(0.1);
            var left = elapsed * ((double)(all - done) / done);
            Draw($"{100.0 * done / all,3:0} %  {done} of {all} {what}  {(long)left.TotalHours:00}:{left:mm\\:ss} left  {now}".TrimEnd());
        }
    }

    public void Dispose()
    {
        lock (drawing)
        {
            if (drawn > 0) Draw("");
            isGone = true;
        }
    }

    private void Draw(string text)
    {
        if (isGone) return;
        text = text[..Math.Min(text.Length, MaxLength)];
        try
        {
            output.Write('\r' + text.PadRight(drawn) + (text.Length == 0 ? "\r" : ""));
            output.Flush();
            drawn = text.Length;
        }
        catch (IOException)
        {
            isGone = true; // the terminal was closed; the work continues
        }
    }
}
