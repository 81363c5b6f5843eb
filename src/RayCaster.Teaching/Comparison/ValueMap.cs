namespace RayCaster.Teaching.Comparison;

/// <summary>
/// The first way to be wrong: each shown byte is a function of the right one, perhaps of another channel. Then all outlines are right.
/// </summary>
/// <param name="order">The channel of the right picture that each shown channel follows from.</param>
/// <param name="shown">For each channel, or for all together, the byte that each right byte becomes; −1 where it does not occur.</param>
/// <param name="left">How many pixels are otherwise.</param>
internal sealed class ValueMap(string order, int[][] shown, int left)
{
    /// <summary>The share of the wrong pixels that may be otherwise.</summary>
    private const double MostLeft = 0.05;

    /// <summary>As many wrong pixels must speak for each byte that changes, on average: fewer are of some function by chance.</summary>
    private const int LeastPixels = 4;

    /// <summary>What a surprising byte costs, and what all of them cost at most: a table is shorter than the picture.</summary>
    private const double PerSurprise = 1, MostSurprises = 15;

    private static readonly string[] orders = ["RGB", "BGR", "GRB", "RBG", "GBR", "BRG"];

    private int[] Changed => field ??= [.. Enumerable.Range(0, 256).Where(right => Array.Exists(shown, table => IsChanged(table, right)))];

    private int[] Occurring => field ??= [.. Enumerable.Range(0, 256).Where(right => Array.Exists(shown, table => table[right] >= 0))];

    private Explanation Explanation => new(Way.Values, Sentence, Priors.Values + Math.Min(MostSurprises, PerSurprise * shown.Max(Surprises)), left);

    private string Sentence
    {
        get
        {
            var read = order == "RGB" ? "" : $"Read as {order} it is right{(Changed.Length == 0 ? "" : " but for its values")}: " +
                "are red, green and blue written in another order?";
            if (Changed.Length == 0) return read;
            var first = Changed[0];
            var isFromThere = first > Occurring[0] && Occurring.Where(right => right >= first).All(Changed.Contains);
            var middle = Changed[Changed.Length / 2];
            return $"{read}{(read == "" ? "" : " ")}All outlines are right, the bytes are not: each of them follows from the right one. " +
                $"{first} becomes {ShownFor(first)}{(middle == first ? "" : $", {middle} becomes {ShownFor(middle)}")}" +
                (isFromThere ? $"; below {first} all are right" : "") +
                ". Look at the attenuation, and at the way from a colour to its bytes.";
        }
    }

    /// <summary>What is said if the bytes of a picture follow from the right ones; null if they do not.</summary>
    /// <param name="isOfMostValues">Whether at least half of the values must change.</param>
    public static Explanation? Find(PictureDifference difference, bool isOfMostValues)
    {
        if (difference.Wrong == 0 || difference.Mine.IsNearlyOneColor) return null;
        var best = orders.SelectMany(order => (ValueMap[])[Of(difference, order, isOneTable: true), Of(difference, order, isOneTable: false)])
            .MinBy(map => map.Explanation.Total(difference.Wrong))!;
        return best.Left <= MostLeft * difference.Wrong && best.Changed.Length * LeastPixels <= difference.Wrong
            && (!isOfMostValues || best.Changed.Length == 0 || 2 * best.Changed.Length >= best.Occurring.Length) ? best.Explanation : null;
    }

    private int Left => left;

    private static ValueMap Of(PictureDifference difference, string order, bool isOneTable)
    {
        var (mine, right) = (difference.Mine.Rgb, difference.Reference.Rgb);
        int[] from = [.. "RGB".Select(letter => order.IndexOf(letter))];
        var counts = new int[isOneTable ? 1 : 3][];
        foreach (ref var count in counts.AsSpan()) count = new int[1 << 16];
        for (var i = 0; i < mine.Length; i += 3)
            for (var c = 0; c < 3; c++) counts[isOneTable ? 0 : c][right[i + from[c]] << 8 | mine[i + c]]++;
        int[][] shown = [.. counts.Select(count => Enumerable.Range(0, 256).Select(value => MostFrequent(count.AsSpan(value << 8, 256))).ToArray())];
        var left = 0;
        for (var i = 0; i < mine.Length; i += 3)
            for (var c = 0; c < 3; c++)
            {
                if (Math.Abs(shown[isOneTable ? 0 : c][right[i + from[c]]] - mine[i + c]) <= PictureJudge.Tolerance) continue;
                left++;
                break;
            }
        return new(order, shown, left);
    }

    private static int MostFrequent(ReadOnlySpan<int> counts)
    {
        var best = 0;
        for (var value = 1; value < counts.Length; value++)
            if (counts[value] > counts[best]) best = value;
        return counts[best] == 0 ? -1 : best;
    }

    private static bool IsChanged(int[] table, int right) => table[right] >= 0 && Math.Abs(table[right] - right) > PictureJudge.Tolerance;

    private int ShownFor(int right) => shown.First(table => IsChanged(table, right))[right];

    /// <summary>How many bytes do not become what those below them lead to expect: the same, as many levels more or fewer, or on one line.</summary>
    private static int Surprises(int[] table)
    {
        int[] right = [.. Enumerable.Range(0, 256).Where(value => table[value] >= 0)];
        return right.Index().Count(at =>
        {
            if (!IsChanged(table, at.Item)) return false;
            if (at.Index == 0) return true;
            var (before, value) = (right[at.Index - 1], table[at.Item]);
            var (step, rise) = (at.Item - before, value - table[before]);
            if (Math.Abs(rise) <= 1 || Math.Abs(rise - step) <= 1) return false;
            if (at.Index == 1) return true;
            var (least, twice) = (right[at.Index - 2], table[before]);
            return Math.Abs(rise - (double)(twice - table[least]) / (before - least) * step) > 2;
        });
    }
}
