using System.Runtime.ExceptionServices;

namespace RayCaster.Files;

/// <summary>Work on the parts of something long, side by side.</summary>
internal static class Ranges
{
    /// <summary>The number of elements in each part but the last: a multiple of 3, and enough to be worth a thread's while.</summary>
    public const int Usual = 3 << 15;

    /// <summary>Does the work on each range of an array, given as start and length.</summary>
    public static void Each(int arrayLength, int threads, Action<int, int> work) =>
        EachPiece(CountIn(arrayLength), threads, i => work(i * Usual, Math.Min(Usual, arrayLength - i * Usual)));

    /// <summary>Does some pieces of work, 0 to count − 1, in any order; in order and without another thread where one is enough.</summary>
    /// <param name="count">How many pieces.</param>
    /// <param name="threads">On how many threads at most, the caller's included.</param>
    /// <param name="work">Does a piece. After an exception no other piece is begun, and the exception is thrown here.</param>
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

    /// <summary>How many ranges an array has.</summary>
    public static int CountIn(int arrayLength) => (int)((arrayLength + Usual - 1L) / Usual);
}
