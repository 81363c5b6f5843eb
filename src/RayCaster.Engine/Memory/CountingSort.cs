namespace RayCaster.Engine;

/// <summary>Sorts items by a small number, their place, on several threads. Items of the same place keep their order.</summary>
internal static class CountingSort
{
    /// <summary>Sorts shares of the items, each on a thread.</summary>
    /// <param name="places">All places are less than this.</param>
    /// <param name="count">Counts the items of a share by place.</param>
    /// <param name="put">Puts the items of a share where they belong: it gets the next position of each place, and moves it on.</param>
    /// <returns>The first position of each place, and the number of items as the last.</returns>
    public static int[] Sort(int shares, int places, Action<int, int[]> count, Action<int, int[]> put)
    {
        var next = new int[shares][];
        ThreadTeam.Each(shares, shares, share => count(share, next[share] = new int[places]));
        var (starts, sum) = (new int[places + 1], 0);
        for (var place = 0; place < places; place++)
        {
            starts[place] = sum;
            foreach (var positions in next) (positions[place], sum) = (sum, sum + positions[place]);
        }
        starts[places] = sum;
        ThreadTeam.Each(shares, shares, share => put(share, next[share]));
        return starts;
    }
}
