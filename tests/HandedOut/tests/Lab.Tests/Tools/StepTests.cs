using System.Diagnostics;

namespace Lab.Tests;

/// <summary>
/// Tests of a step. One that does not end stops the run. Processor time counts, because on a busy machine any test may take a minute.
/// </summary>
public abstract class StepTests : IDisposable
{
    /// <summary>The slowest test needs a small part of it.</summary>
    private static readonly TimeSpan limit = TimeSpan.FromMinutes(1);

    private static long spentBefore; // when a test last began or ended, in ticks

    static StepTests() => new Thread(Watch) { IsBackground = true }.Start();

    /// <summary>xunit makes an object for each test.</summary>
    protected StepTests() => Volatile.Write(ref spentBefore, Environment.CpuUsage.TotalTime.Ticks);

    public void Dispose()
    {
        Volatile.Write(ref spentBefore, Environment.CpuUsage.TotalTime.Ticks);
        GC.SuppressFinalize(this);
    }

    private static void Watch()
    {
        while (Environment.CpuUsage.TotalTime.Ticks - Volatile.Read(ref spentBefore) < limit.Ticks) Thread.Sleep(500);
        Process.GetCurrentProcess().Kill(); // the table of steps says in which test
    }
}
