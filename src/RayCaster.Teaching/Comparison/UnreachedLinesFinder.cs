namespace RayCaster.Teaching.Comparison;

/// <summary>Finds whole lines and columns that have one colour and should not.</summary>
internal static class UnreachedLinesFinder
{
    /// <summary>How many colours are tried, the most frequent of the wrong pixels first.</summary>
    private const int Colors = 3;

    /// <summary>Finds them; null if there are none, or if hardly anything else is there, or one other colour.</summary>
    public static UnreachedLines? Find(PictureDifference difference)
    {
        var (mine, wrong) = (difference.Mine, Enumerable.Range(0, difference.Pixels).Where(difference.IsWrong));
        if (mine.IsNearlyOneColor) return null;
        foreach (var (color, _) in wrong.CountBy(mine.At).OrderByDescending(color => color.Value).Take(Colors))
        {
            var lines = Whole(mine.Height, mine.Width, (along, across) => across * mine.Width + along);
            var columns = Whole(mine.Width, mine.Height, (along, across) => along * mine.Width + across);
            if (lines.Length + columns.Length == 0 || 4 * lines.Length > 3 * mine.Height || 4 * columns.Length > 3 * mine.Width) continue;
            var found = new UnreachedLines(lines, columns, color, mine);
            var left = Enumerable.Range(0, mine.Count).Where(i => !found.Contains(i % mine.Width, i / mine.Width)).Select(mine.At);
            if (left.Distinct().Take(2).Count() > 1) return found;

            int[] Whole(int count, int length, Func<int, int, int> place) =>
            [
                .. Enumerable.Range(0, count).Where(across => Enumerable.Range(0, length).All(along => mine.At(place(along, across)) == color)
                    && Enumerable.Range(0, length).Any(along => difference.IsWrong(place(along, across)))),
            ];
        }
        return null;
    }

    /// <summary>The explanation of a picture that is right but for them, and for the part beside them of a line that was begun; null if it is not.
    /// </summary>
    public static Explanation? Explain(PictureDifference difference, PictureJudge judge)
    {
        if (Find(difference) is not { } found) return null;
        var (mine, right) = (difference.Mine, difference.Reference);
        var rest = Picture.Create(mine.Width, mine.Height, (x, y) => found.Contains(x, y) || IsBegun(x, y) ? right[x, y] : mine[x, y]);
        return judge.Compare(rest) == Likeness.Wrong ? null : new(Way.Places, found.Sentence, Priors.BitsOf(found));

        bool IsBegun(int x, int y) => mine[x, y] == found.Color
            && (found.Contains(x, y - 1) || found.Contains(x, y + 1) || found.Contains(x - 1, y) || found.Contains(x + 1, y));
    }
}
