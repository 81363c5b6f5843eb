namespace RayCaster.Engine;

/// <summary>Sorts items by a small number, their bin, on several threads. Items of the same bin keep their order.</summary>
internal static class CountingSort
{
    /// <summary>Sorts shares of the items, each on a thread.</summary>
    /// <param name="bins">All bins are less than this.</param>
    /// <param name="count">Counts the items of a share by bin.</param>
    /// <param name="put">Puts the items of a share where they belong: it gets the next position of each bin, and moves it on.</param>
    /// <returns>The first position of each bin, and the number of items as the last.</returns>
    public static int[] Sort(int shares, int bins, Action<int, int[]> count, Action<int, int[]> put)
    {
        var next = new int[shares][];
        ThreadTeam.Each(shares, shares, share => count(share, next[share] = new int[bins]));
        var starts = new int[bins + 1];
        var sum = 0;
        for (var bin = 0; bin < bins; bin++)
        {
            starts[bin] = sum;
            foreach (var positions in next) (positions[bin], sum) = (sum, sum + positions[bin]);
        }
        starts[bins] = sum;
        ThreadTeam.Each(shares, shares, share => put(share, next[share]));
        return starts;
    }
}
