using System.Diagnostics;
using System.Globalization;

namespace RayCaster.Cli;

/// <summary>One line on a terminal that counts what is done; wiped at the end.</summary>
/// <param name="isShown">Whether there is somebody to watch.</param>
/// <param name="what">What is counted.</param>
internal sealed class CountLine(bool isShown, string what) : IDisposable
{
    private readonly Lock drawing = new();
    private readonly long start = Stopwatch.GetTimestamp();
    private int drawn;

    /// <summary>Shows how many are done, and about how long the others will take; any thread may call it.</summary>
    public void Show(int done, int all)
    {
        var left = Stopwatch.GetElapsedTime(start) / Math.Max(1, done) * (all - done);
        Draw(string.Create(CultureInfo.InvariantCulture, $"{done} of {all} {what}  {(long)left.TotalMinutes:00}:{left:ss} left"));
    }

    /// <summary>Takes the line away.</summary>
    public void Wipe() => Draw("");

    /// <inheritdoc cref="Wipe"/>
    public void Dispose() => Wipe();

    private void Draw(string text)
    {
        if (!isShown) return;
        lock (drawing)
        {
            if (text.Length == 0 && drawn == 0) return;
            Console.Error.Write('\r' + text.PadRight(drawn) + (text.Length == 0 ? "\r" : ""));
            drawn = text.Length;
        }
    }
}
