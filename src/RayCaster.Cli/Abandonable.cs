using System.Runtime.ExceptionServices;

namespace RayCaster.Cli;

/// <summary>Work that can be left unfinished: after a cancellation, the caller waits only a moment for it.</summary>
internal static class Abandonable
{
    private const int Glance = 50, Moment = 200; // milliseconds

    /// <summary>Does the work on its own thread. The first use of the thread pool would cost each run some milliseconds.</summary>
    /// <exception cref="OperationCanceledException">It was cancelled. Work that does not end within a moment continues, and its result is
    /// ignored.</exception>
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
