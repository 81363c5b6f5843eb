using System.Diagnostics;

namespace Lab.Tests;

/// <summary>
/// Tests of a step. One that does not end stops the run. Processor time counts, because on a busy machine any test may take a minute; a test that
/// waits without end takes none, and has ten minutes.
/// </summary>
public abstract class StepTests : IDisposable
{
    private static readonly TimeSpan limit = TimeSpan.FromSeconds(Teacher.Seconds);

    // When a test last began or ended.
    private static long spentBefore, clockBefore = Stopwatch.GetTimestamp();

    static StepTests() => new Thread(Watch) { IsBackground = true }.Start();

    /// <summary>xunit makes an object for each test.</summary>
    protected StepTests() => Restart();

    public void Dispose()
    {
        Restart();
        GC.SuppressFinalize(this);
    }

    private static void Restart()
    {
        Volatile.Write(ref spentBefore, Environment.CpuUsage.TotalTime.Ticks);
        Volatile.Write(ref clockBefore, Stopwatch.GetTimestamp());
    }

    private static void Watch()
    {
        while (Environment.CpuUsage.TotalTime.Ticks - Volatile.Read(ref spentBefore) < limit.Ticks
            && Stopwatch.GetElapsedTime(Volatile.Read(ref clockBefore)).TotalMinutes < 10) Thread.Sleep(500);
        Process.GetCurrentProcess().Kill(); // the table of steps says in which test
    }
}
