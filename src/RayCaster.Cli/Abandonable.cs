using System.Runtime.ExceptionServices;

namespace RayCaster.Cli;

/// <summary>Work that need not come to its end: whatever it waits for or computes, who cancels it waits no longer than a moment.</summary>
internal static class Abandonable
{
    private const int Glance = 50, Moment = 200; // milliseconds

    /// <summary>Does the work on a thread of its own; the first use of the thread pool would take three milliseconds of each run.</summary>
    /// <exception cref="OperationCanceledException">It is cancelled. Work that does not end within a moment goes on, and nobody hears what comes
    /// of it.</exception>
    public static T Run<T>(Func<T> work, CancellationToken cancellation)
    {
        var (result, failure) = (default(T), default(Exception));
        var thread = new Thread(() =>
        {
            try
            {
                result = work();
            }
            catch (Exception e)
            {
                failure = e;
            }
        })
        { IsBackground = true };
        thread.Start();
        while (!thread.Join(Glance))
            if (cancellation.IsCancellationRequested && !thread.Join(Moment)) throw new OperationCanceledException(cancellation);
        if (failure is not null) ExceptionDispatchInfo.Throw(failure);
        return result!;
    }
}
