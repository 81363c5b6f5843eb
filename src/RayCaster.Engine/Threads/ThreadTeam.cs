using System.Diagnostics;
using System.Runtime.ExceptionServices;

namespace RayCaster.Engine;

/// <summary>Work in pieces, side by side, on threads that then wait for the next: to start a thread takes as long as to cast some ten thousand
/// rays.</summary>
/// <remarks>Not the runtime's pool: its first use takes milliseconds, and often it begins a piece a picture later.</remarks>
internal static class ThreadTeam
{
    /// <summary>How long a thread that waits stays awake: a tenth of a millisecond, in which mostly the next picture has come, or the last of the
    /// others has ended. To be woken takes up to half of that, and now and then much longer on a machine that shares its cores.</summary>
    private static readonly long awake = Stopwatch.Frequency / 10_000;

    private static readonly Queue<Job> offers = new(); // a place in a job for each thread that is to help
    private static int offered;                        // how many there are, for a look without the lock
    private static int free;                           // threads that take offers, now or as soon as they have begun

    /// <summary>Does some pieces of work, 0 to count − 1, in any order; in order and without another thread where one is enough.</summary>
    /// <param name="count">How many pieces.</param>
    /// <param name="threads">On how many threads at most, the caller's included.</param>
    /// <param name="work">Does a piece. After an exception no other piece is begun, and it comes out when those begun have ended.</param>
    public static void Each(int count, int threads, Action<int> work)
    {
        var job = new Job(count, work);
        Offer(job, Math.Min(threads, count) - 1);
        job.Work();
        job.End();
    }

    /// <summary>How many shares so many models are: with fewer than some thousand for each thread, one thread ends before others begin.</summary>
    public static int SharesOf(int models, int threads) => models >> 13 >= threads ? threads : 1;

    /// <summary>Does work on things in equal shares, a thread for each: <c>work(share, first, end)</c>.</summary>
    public static void Shares(int shares, int count, Action<int, int, int> work) => Each(shares, shares, share =>
        work(share, (int)((long)count * share / shares), (int)((long)count * (share + 1) / shares)));

    /// <summary>Does work on this thread while others help; none may come, or some late. Returns when all of them have ended.</summary>
    /// <param name="helpers">How many threads help at most.</param>
    /// <param name="help">What each of them does. It must end soon after the work has ended, by an exception, too.</param>
    /// <param name="work">What this thread does; its exception comes out.</param>
    public static void Help(int helpers, Action help, Action work)
    {
        var job = new Job(helpers, _ => help());
        Offer(job, helpers);
        try
        {
            work();
        }
        finally
        {
            job.End();
        }
    }

    private static void Offer(Job job, int places)
    {
        if (places <= 0) return;
        lock (offers)
        {
            for (; places > 0 && (offers.Count < free || TryStart()); places--) offers.Enqueue(job);
            offered = offers.Count;
            Monitor.PulseAll(offers);
        }
    }

    /// <summary>Starts a thread; false where the system gives no more, so that those who are there do the work.</summary>
    private static bool TryStart()
    {
        try
        {
            new Thread(Help) { IsBackground = true, Name = "worker" }.Start();
            free++;
            return true;
        }
        catch (Exception e) when (e is OutOfMemoryException or ThreadStartException)
        {
            return false;
        }
    }

    private static void Help()
    {
        while (true)
        {
            HelpOnce();
            lock (offers) free++;
        }
    }

    /// <summary>Takes part in a job; afterwards nothing of it is kept in memory.</summary>
    private static void HelpOnce()
    {
        Job job;
        StayAwakeWhile(ref offered, isZero: true);
        lock (offers)
        {
            while (offers.Count == 0) Monitor.Wait(offers);
            job = offers.Dequeue();
            offered = offers.Count;
            free--;
        }
        job.Help();
    }

    private static void StayAwakeWhile(ref int count, bool isZero)
    {
        for (var end = Stopwatch.GetTimestamp() + awake; Volatile.Read(ref count) == 0 == isZero && Stopwatch.GetTimestamp() < end;)
            Thread.SpinWait(8);
    }

    /// <summary>The pieces of one call.</summary>
    private sealed class Job(int count, Action<int> work)
    {
        private readonly object gate = new();
        private int next = -1, helpers;
        private bool isOver; // guarded by the lock, as the number of helpers is
        private ExceptionDispatchInfo? failure;

        public void Work()
        {
            try
            {
                while (Volatile.Read(ref failure) is null && Interlocked.Increment(ref next) is var i && i < count) work(i);
            }
            catch (Exception e)
            {
                Interlocked.CompareExchange(ref failure, ExceptionDispatchInfo.Capture(e), null);
            }
        }

        /// <summary>The same on another thread, if it does not come too late.</summary>
        public void Help()
        {
            lock (gate)
            {
                if (isOver) return;
                helpers++;
            }
            Work();
            lock (gate)
            {
                helpers--;
                Monitor.Pulse(gate);
            }
        }

        /// <summary>Waits for those who help, but not for those who have not come.</summary>
        public void End()
        {
            StayAwakeWhile(ref helpers, isZero: false);
            lock (gate)
            {
                isOver = true;
                while (helpers > 0) Monitor.Wait(gate);
            }
            failure?.Throw();
        }
    }
}
