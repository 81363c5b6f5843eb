using System.Diagnostics;
using System.Runtime.ExceptionServices;

namespace RayCaster.Engine;

/// <summary>Runs jobs in parallel. Its threads then wait for the next job: starting a thread takes as long as casting some ten thousand
/// rays.</summary>
/// <remarks>The runtime's pool is slower: its first use takes as long as a small picture, and it often starts a piece one picture too
/// late.</remarks>
internal static class ThreadTeam
{
    /// <summary>How long a waiting thread spins: usually the next picture comes, or the last thread ends, within that time. Waking a thread takes up
    /// to half of it, and sometimes much longer on a machine that shares its cores.</summary>
    private static readonly long awake = Stopwatch.Frequency / 10_000;

    private static readonly Queue<Job> offers = new(); // one entry for each thread that is to help
    private static int offered;                        // the number of entries, to be read without the lock
    private static int free;                           // threads that take offers, now or once they have started

    /// <summary>Does pieces 0 to count − 1 of some work, in any order; in order if there is only one thread.</summary>
    /// <param name="count">The number of pieces.</param>
    /// <param name="threads">The most threads, including the caller's.</param>
    /// <param name="work">Does a piece. After an exception no other piece starts; it is thrown when all running pieces have ended.</param>
    public static void Each(int count, int threads, Action<int> work)
    {
        var job = new Job(count, work);
        Offer(job, Math.Min(threads, count) - 1);
        job.Work();
        job.End();
    }

    /// <summary>Into how many shares to divide this many models: with few for each thread, one thread ends before the others start.</summary>
    public static int SharesOf(int models, int threads) => models >> 13 >= threads ? threads : 1;

    /// <summary>Divides items into equal shares and processes each on a thread: <c>work(share, first, end)</c>.</summary>
    public static void Shares(int shares, int count, Action<int, int, int> work) => Each(shares, shares, share =>
        work(share, (int)((long)count * share / shares), (int)((long)count * (share + 1) / shares)));

    /// <summary>Does work on this thread while others help; perhaps none comes, or some late. Returns when all of them have ended.</summary>
    /// <param name="helpers">The most threads that help.</param>
    /// <param name="help">What each of them does. It must end soon after the work has ended, also by an exception.</param>
    /// <param name="work">What this thread does; its exception is thrown.</param>
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

    /// <summary>Starts a thread; false if the system allows no more, so that the existing ones do the work.</summary>
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

    /// <summary>Takes part in a job. As a method of its own, so that nothing of the job stays in memory.</summary>
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

    private sealed class Job(int count, Action<int> work)
    {
        private readonly object gate = new();
        private int next = -1, helpers;
        private bool isDone; // guarded by the lock, like the number of helpers
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

        /// <summary>The same on another thread, unless the job is over.</summary>
        public void Help()
        {
            lock (gate)
            {
                if (isDone) return;
                helpers++;
            }
            Work();
            lock (gate)
            {
                helpers--;
                Monitor.Pulse(gate);
            }
        }

        /// <summary>Waits for the helpers that have started.</summary>
        public void End()
        {
            StayAwakeWhile(ref helpers, isZero: false);
            lock (gate)
            {
                isDone = true;
                while (helpers > 0) Monitor.Wait(gate);
            }
            failure?.Throw();
        }
    }
}
