namespace RayCaster.Cli;

/// <summary>
/// A progress line on the terminal: drawn only if the work takes long, at most ten times a second, and wiped at the end. Any thread may use it.
/// </summary>
/// <param name="what">What is counted.</param>
internal sealed class ProgressLine(TextWriter output, string what, int columns, TimeProvider clock) : IDisposable
{
    private const int UsualColumns = 80, MinColumns = 20;

    private static readonly TimeSpan InitialDelay = TimeSpan.FromSeconds(0.5);
    private static readonly TimeSpan UpdateInterval = TimeSpan.FromSeconds(0.1);

    private static ProgressLine? seen;

    private readonly long start = clock.GetTimestamp();
    private readonly Lock drawing = new();
    private long due = InitialDelay.Ticks;
    private int linesDone, drawn;
    private bool isGone;

    private static bool IsSeen =>
        !Console.IsErrorRedirected
        && Environment.GetEnvironmentVariable("TERM") != "dumb"
        && string.IsNullOrEmpty(Environment.GetEnvironmentVariable("CI"));

    /// <summary>A progress line on standard error's terminal; null if it is not wanted, or nobody sees it.</summary>
    public static ProgressLine? For(CommandLine line, string what = "lines") =>
        line.Get(Option.Quiet) || !IsSeen ? null : seen = new(Console.Error, what, Columns(), TimeProvider.System);

    /// <summary>Ends the line that is seen, if any.</summary>
    public static void Wipe() => seen?.Dispose();

    /// <summary>The terminal's columns; 80 if it does not say.</summary>
    private static int Columns()
    {
        try
        {
            return Console.WindowWidth is >= MinColumns and var columns ? columns : UsualColumns;
        }
        catch (IOException)
        {
            return UsualColumns;
        }
    }

    /// <summary>Counts finished lines of a picture.</summary>
    public void LinesDone(int lines, int height) => Show(Interlocked.Add(ref linesDone, lines), height);

    /// <summary>Shows how many are done of all, and the time that is left.</summary>
    /// <param name="now">What is being done; empty if that needs no name.</param>
    public void Show(int done, int all, string now = "")
    {
        var (elapsed, next) = (clock.GetElapsedTime(start), Volatile.Read(ref due));
        if (done == 0 || elapsed.Ticks < next) return;
        if (Interlocked.CompareExchange(ref due, (elapsed + UpdateInterval).Ticks, next) != next) return; // another thread draws
        var left = elapsed * ((double)(all - done) / done);
        Draw($"{100.0 * done / all,3:0} %  {done} of {all} {what}  {(long)left.TotalHours:00}:{left:mm\\:ss} left  {now}".TrimEnd());
    }

    public void Dispose()
    {
        if (drawn > 0) Draw("");
        isGone = true;
    }

    private void Draw(string text)
    {
        lock (drawing)
        {
            if (isGone) return;
            text = text[..Math.Min(text.Length, columns - 1)]; // a character in the last column would wrap the line
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
}
