namespace RayCaster;

/// <summary>Work on the parts of a long array, side by side.</summary>
internal static class Ranges
{
    /// <summary>The number of elements in each part but the last: a multiple of 3, and enough to be worth a thread's while.</summary>
    public const int Usual = 3 << 15;

    /// <summary>Does the work on each range of an array, given as start and length.</summary>
    public static void Each(int arrayLength, int threads, Action<int, int> work) =>
        Workers.Each(CountIn(arrayLength), threads, i => work(i * Usual, Math.Min(Usual, arrayLength - i * Usual)));

    /// <summary>How many ranges an array has.</summary>
    public static int CountIn(int arrayLength) => (int)((arrayLength + Usual - 1L) / Usual);
}
