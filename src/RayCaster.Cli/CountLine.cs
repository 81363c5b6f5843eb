using System.Diagnostics;
using System.Globalization;

namespace RayCaster.Cli;

/// <summary>A line on the terminal that counts finished work; wiped at the end.</summary>
internal sealed class CountLine(bool isShown, string what) : IDisposable
{
    private readonly Lock drawing = new();
    private readonly long start = Stopwatch.GetTimestamp();
    private int drawn;

    /// <summary>Shows how many are done, and the estimated time for the rest. Any thread may call it.</summary>
    public void Show(int done, int all)
    {
        var left = Stopwatch.GetElapsedTime(start) / Math.Max(1, done) * (all - done);
        Draw(string.Create(CultureInfo.InvariantCulture, $"{done} of {all} {what}  {(long)left.TotalMinutes:00}:{left:ss} left"));
    }

    public void Wipe() => Draw("");

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
