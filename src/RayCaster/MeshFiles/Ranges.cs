using System.Runtime.ExceptionServices;

namespace RayCaster;

/// <summary>Work in pieces, or on the parts of a long array, side by side.</summary>
internal static class Ranges
{
    /// <summary>The number of elements in each part but the last: a multiple of 3, and enough to be worth a thread's while.</summary>
    public const int Usual = 3 << 15;

    /// <summary>Does some pieces of work, 0 to count − 1, in any order; in order and without another thread where one is enough.</summary>
    public static void Each(int count, int threads, Action<int> work)
    {
        var next = -1;
        var failure = default(Exception);
        var others = new Thread[Math.Max(0, Math.Min(threads, count) - 1)]; // plain ones: the first use of Parallel takes milliseconds
        for (var i = 0; i < others.Length; i++) (others[i] = new(Work) { IsBackground = true, Name = "worker" }).Start();
        Work();
        foreach (var other in others) other.Join();
        if (failure is not null) ExceptionDispatchInfo.Throw(failure);

        void Work()
        {
            try
            {
                while (Volatile.Read(ref failure) is null && Interlocked.Increment(ref next) is var i && i < count) work(i);
            }
            catch (Exception e)
            {
                Interlocked.CompareExchange(ref failure, e, null);
            }
        }
    }

    /// <summary>Does the work on each range of an array, given as start and length.</summary>
    public static void Each(int arrayLength, int threads, Action<int, int> work) =>
        Each(CountIn(arrayLength), threads, i => work(i * Usual, Math.Min(Usual, arrayLength - i * Usual)));

    /// <summary>How many ranges an array has.</summary>
    public static int CountIn(int arrayLength) => (int)((arrayLength + Usual - 1L) / Usual);
}
