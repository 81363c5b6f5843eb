using System.Diagnostics;

namespace RayCaster.Teaching;

/// <summary>How much processor time a search for mistakes may take, from now on. A search that has spent it returns what it has found.</summary>
/// <param name="processorTime">The time of all cores together.</param>
/// <param name="cancellation">If cancelled, the search ends in the same way.</param>
public sealed class SearchBudget(TimeSpan processorTime, CancellationToken cancellation = default)
{
    /// <summary>The limit if the user sets no other.</summary>
    public static readonly TimeSpan Usual = TimeSpan.FromSeconds(6);

    private readonly TimeSpan end = Spent + processorTime;

    /// <summary>Whether something was left out.</summary>
    public bool LeavesOut { get; private set; }

    /// <summary>This process's processor time. A browser does not tell it, but has one thread.</summary>
    private static TimeSpan Spent => OperatingSystem.IsBrowser() ? Stopwatch.GetElapsedTime(0) : Environment.CpuUsage.TotalTime;

    /// <summary>Whether the time is over; read before each piece of work that is then left out.</summary>
    internal bool IsSpent()
    {
        // Once spent, always spent: the system's clock of processor time may go back a little between two threads' calls.
        if (cancellation.IsCancellationRequested || Spent > end) LeavesOut = true;
        return LeavesOut;
    }

    /// <exception cref="TimeoutException">The time is over.</exception>
    internal void ThrowIfSpent()
    {
        if (IsSpent()) throw new TimeoutException();
    }
}
