namespace RayCaster.Teaching;

/// <summary>How much processor time a search for mistakes may take, from now on. A search that has spent it returns what it has found.</summary>
/// <param name="processorTime">The time of all cores together.</param>
/// <param name="cancellation">If cancelled, the search ends in the same way.</param>
public sealed class SearchBudget(TimeSpan processorTime, CancellationToken cancellation = default)
{
    /// <summary>What a user waits for without a question.</summary>
    public static readonly TimeSpan Usual = TimeSpan.FromSeconds(10);

    private readonly TimeSpan end = Environment.CpuUsage.TotalTime + processorTime;

    /// <summary>Whether something was left out.</summary>
    public bool LeavesOut { get; private set; }

    /// <summary>Whether the time is over; read before each piece of work that is then left out.</summary>
    internal bool IsSpent()
    {
        // Once spent, always spent: several threads ask, and the system's clock of processor time may go back a little.
        if (cancellation.IsCancellationRequested || Environment.CpuUsage.TotalTime > end) LeavesOut = true;
        return LeavesOut;
    }

    /// <exception cref="TimeoutException">The time is over.</exception>
    internal void ThrowIfSpent()
    {
        if (IsSpent()) throw new TimeoutException();
    }
}
