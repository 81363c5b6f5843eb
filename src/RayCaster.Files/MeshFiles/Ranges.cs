using System.Runtime.ExceptionServices;

namespace RayCaster.Files;

/// <summary>Divides work among threads.</summary>
internal static class Ranges
{
    /// <summary>The elements of each range but the last: a multiple of 3, and enough work for a thread.</summary>
    public const int Usual = 3 << 15;

    /// <summary>Does the work on each range of an array, given as start and length.</summary>
    public static void Each(int arrayLength, int threads, Action<int, int> work) =>
        EachPiece((int)((arrayLength + Usual - 1L) / Usual), threads, i => work(i * Usual, Math.Min(Usual, arrayLength - i * Usual)));

    /// <summary>Does pieces 0 to count − 1 of some work: on one thread in order, on several in any order.</summary>
    /// <param name="threads">How many threads at most, the caller's included.</param>
    /// <param name="work">Does a piece. After an exception no other piece is started, and the exception is thrown here.</param>
    public static void EachPiece(int count, int threads, Action<int> work)
    {
        if (Math.Min(count, threads) <= 1)
        {
            for (var i = 0; i < count; i++) work(i);
            return;
        }
        try
        {
            Parallel.For(0, count, new ParallelOptions { MaxDegreeOfParallelism = threads }, work);
        }
        catch (AggregateException several)
        {
            ExceptionDispatchInfo.Throw(several.InnerExceptions[0]);
        }
    }
}
