using System.Runtime.ExceptionServices;

namespace RayCaster.Cli;

/// <summary>Work that leaves nothing behind, so that who cancels need not wait for its end.</summary>
internal static class Abandonable
{
    private const int Glance = 50; // milliseconds

    /// <inheritdoc cref="Run{T}"/>
    public static void Run(Action work, CancellationToken cancellation) => Run(() =>
    {
        work();
        return true;
    }, cancellation);

    /// <summary>Does the work on a thread of its own; the first use of the thread pool would take three milliseconds of each run.</summary>
    /// <exception cref="OperationCanceledException">It is cancelled. The work goes on, and nobody hears what comes of it.</exception>
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
        while (!thread.Join(Glance)) cancellation.ThrowIfCancellationRequested();
        if (failure is not null) ExceptionDispatchInfo.Throw(failure);
        return result!;
    }
}
