namespace RayCaster.Cli;

/// <summary>
/// A progress line on the terminal: drawn only if the work takes long, at most ten times a second, and wiped at the end.
/// </summary>
/// <param name="width">Pixels in a line of the picture; 0 if there is no picture, and something else is counted.</param>
/// <param name="what">What is counted for each pixel: rays, or something else if no rays are cast.</param>
internal sealed class ProgressLine(TextWriter output, int width, int height, int columns, TimeProvider clock, string what = "rays") : IDisposable
{
    private const int UsualColumns = 80, MinColumns = 20;

    private static readonly TimeSpan InitialDelay = TimeSpan.FromSeconds(0.5);
    private static readonly TimeSpan UpdateInterval = TimeSpan.FromSeconds(0.1);

    private readonly long start = clock.GetTimestamp();
    private readonly Lock drawing = new();
    private TimeSpan lastDrawn = InitialDelay - UpdateInterval;
    private int linesDone, drawn;
    private bool isGone;

    private static bool IsSeen =>
        !Console.IsErrorRedirected
        && Environment.GetEnvironmentVariable("TERM") != "dumb"
        && string.IsNullOrEmpty(Environment.GetEnvironmentVariable("CI"));

    /// <summary>A progress line on standard error's terminal; null if it is not wanted, or nobody sees it.</summary>
    public static ProgressLine? For(CommandLine line, int width, int height, string what = "rays") =>
        line.Get(Option.Quiet) || !IsSeen ? null
            : new(Console.Error, width, height, Columns(), TimeProvider.System, what);

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

    /// <summary>Counts finished lines of the picture. Any thread may call it.</summary>
    public void LinesDone(int lines) => Show(Interlocked.Add(ref linesDone, lines), height);

    /// <summary>Shows how many are done of all. Any thread may call it.</summary>
    /// <param name="now">What is being done; empty if that needs no name.</param>
    public void Show(int done, int all, string now = "")
    {
        var elapsed = clock.GetElapsedTime(start);
        if (isGone || done == 0 || elapsed < InitialDelay || !drawing.TryEnter()) return;
        try
        {
            if (elapsed - lastDrawn < UpdateInterval) return;
            lastDrawn = elapsed;
            Draw($"{Text(done, all, elapsed)}  {now}".TrimEnd());
        }
        finally
        {
            drawing.Exit();
        }
    }

    public void Dispose()
    {
        lock (drawing)
            if (drawn > 0) Draw("");
    }

    /// <summary>A speed in words: in millions, but for a small picture or a slow formula, where that would be 0.0.</summary>
    public static string Rate(double count, string what, TimeSpan elapsed)
    {
        var rate = count / elapsed.TotalSeconds;
        return (rate < 1e5 ? $"{rate:N0}" : $"{rate / 1e6:0.0} million") + $" {what} per second";
    }

    private string Text(int done, int all, TimeSpan elapsed)
    {
        var share = (double)done / all;
        var left = TimeSpan.FromSeconds(elapsed.TotalSeconds / share * (1 - share));
        return $"{share * 100,3:0} %  {done} of {all} {(width > 0 ? $"lines  {Rate((double)done * width, what, elapsed)}  " : $"{what}  ")}" +
            $"{(long)left.TotalHours:00}:{left:mm\\:ss} left";
    }

    private void Draw(string text)
    {
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
            drawn = 0;
        }
    }
}
