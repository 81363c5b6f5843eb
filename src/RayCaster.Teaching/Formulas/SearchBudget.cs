using System.Diagnostics;

namespace RayCaster.Teaching.Formulas;

/// <summary>
/// How much work a search for mistakes may do, from now on. A search that has done it returns what it has found. Work is the same on every machine,
/// however busy it is and with any number of threads, so the answer is, too; time is limited only as a last resort.
/// </summary>
/// <param name="work">How much may be computed: about operations of formulas times pixels.</param>
/// <param name="lastResort">The processor time of all cores together; a minute if left out.</param>
/// <param name="cancellation">If cancelled, the search ends in the same way.</param>
/// <remarks>For one search after another: of two at the same time, it would depend on the machine which one does how much.</remarks>
public sealed class SearchBudget(long work = SearchBudget.Usual, TimeSpan? lastResort = null, CancellationToken cancellation = default)
{
    /// <summary>The work that is done if the user sets no limit: some six seconds of a core.</summary>
    public const long Usual = 6_000_000_000;

    /// <summary>The processor time after which a search ends if it has not done its work by then.</summary>
    public static readonly TimeSpan LastResort = TimeSpan.FromSeconds(60);

    private readonly TimeSpan time = lastResort ?? LastResort;
    private readonly TimeSpan begin = ProcessorTime;
    private long done;
    private volatile bool isOver;

    /// <summary>What the search has used up, in words, so that something was left out; null if nothing was.</summary>
    public string? UsedUp { get; private set; }

    /// <summary>How much work has been done.</summary>
    internal long Done => Interlocked.Read(ref done);

    /// <summary>This process's processor time. A browser does not tell it, but has one thread.</summary>
    private static TimeSpan ProcessorTime => OperatingSystem.IsBrowser() ? Stopwatch.GetElapsedTime(0) : Environment.CpuUsage.TotalTime;

    internal void Spend(long more) => Interlocked.Add(ref done, more);

    /// <summary>Whether nothing more may be done; read before each piece of work that is then left out.</summary>
    internal bool IsSpent()
    {
        if (Done >= work) UsedUp ??= "the usual amount of work";
        else if (IsOver()) UsedUp ??= string.Create(CultureInfo.InvariantCulture, $"{time.TotalSeconds:0} s of processor time");
        return UsedUp is not null;
    }

    /// <summary>Whether the search must end at once.</summary>
    private bool IsOver()
    {
        // Once over, always over: the system's clock of processor time may go back a little between two threads' calls.
        if (cancellation.IsCancellationRequested || ProcessorTime - begin > time) isOver = true;
        return isOver;
    }

    /// <summary>Does pieces of work in parallel, some together. Once a budget is spent, no others begin: how much is done does not depend on which
    /// thread is the faster one.</summary>
    /// <param name="budget">Null for no limit.</param>
    /// <returns>How many pieces are done, the first ones. Others may be done, too, if the time is over.</returns>
    internal static int Do(SearchBudget? budget, int pieces, int together, int? threads, Action<int> piece)
    {
        var options = new ParallelOptions { MaxDegreeOfParallelism = threads ?? Environment.ProcessorCount };
        for (var first = 0; first < pieces; first += together)
        {
            if (budget?.IsSpent() == true) return first;
            var end = Math.Min(pieces, first + together);
            var loop = Parallel.For(first, end, options, (i, loop) =>
            {
                if (budget?.IsOver() == true) loop.Stop();
                else piece(i);
            });
            if (!loop.IsCompleted)
            {
                budget!.IsSpent(); // takes down why
                return first;
            }
        }
        return pieces;
    }
}
