namespace RayCaster.Teaching.Comparison;

/// <summary>Wrong pixels that lie alone, as if by chance. Over models of several kinds no formula draws them; on models of one kind,
/// holes.</summary>
internal sealed class LostPixels
{
    /// <summary>So many wrong pixels show how they lie; a model that is wrong in a smaller share than this part of the mean is spared.</summary>
    private const int Least = 20, Part = 4;

    /// <summary>The share of the pixels that lie alone by chance, and of those that must.</summary>
    private const double LeastAlone = 0.8, MostWrong = 0.5;

    private readonly PictureDifference difference;
    private readonly int count;

    private LostPixels(PictureDifference difference, int count, string[] kinds) => (this.difference, this.count, Kinds) = (difference, count, kinds);

    /// <summary>The kinds of shape that they lie on, as scene files call them; an empty text for the background.</summary>
    public IReadOnlyList<string> Kinds { get; }

    /// <summary>What explains them, if they lie on more than one kind; otherwise null.</summary>
    public Explanation? Explanation => Kinds.Count < 2 ? null : new(Way.Places,
        $"{Digits.Count(count, "single pixel")}, spread over the picture, are wrong{Shown}; all others are right, so no formula " +
        "is wrong. Do threads share what each must have for itself, for example the pixel's place?", Priors.SinglePixels);

    private string Shown => Enumerable.Range(0, difference.Pixels).Where(difference.IsWrong).Select(difference.Mine.At).Distinct().Take(2).ToArray()
        is [var color] ? $", {color}" : "";

    /// <summary>Finds them; null if the wrong pixels lie beside each other, or on some models only.</summary>
    /// <param name="modelAt">The model that each pixel should show; −1 for the background.</param>
    public static LostPixels? Find(PictureDifference difference, Scene scene, IReadOnlyList<int> modelAt)
    {
        var width = difference.Mine.Width;
        int[] wrong = [.. Enumerable.Range(0, difference.Pixels).Where(difference.IsWrong)];
        if (wrong.Length < Least) return null;
        // How many pixels of each model there are, and how many of these are wrong.
        var models = modelAt.Index().GroupBy(pixel => pixel.Item, pixel => pixel.Index)
            .Select(pixels => (Model: pixels.Key, All: pixels.Count(), Wrong: pixels.Count(difference.IsWrong))).ToArray();
        var area = models.Where(model => model.Wrong > 0).Sum(model => model.All);
        var share = (double)wrong.Length / area;
        var alone = wrong.Count(i => !IsWrong(i, -1) && !IsWrong(i, 1) && !IsWrong(i, -width) && !IsWrong(i, width));
        if (share > MostWrong || alone < LeastAlone * Math.Pow(1 - share, 4) * wrong.Length) return null;
        string[] kinds = [.. models.Where(model => model.Wrong > 0)
            .Select(model => model.Model < 0 ? "" : scene.Models[model.Model].Kind).Distinct()];
        // Lost pixels are on each model, in about the same share.
        if (kinds.Length > 1 && models.Any(model => model.Model >= 0 && model.All * share > Least
            && model.Wrong < model.All * share / Part)) return null;
        return new(difference, wrong.Length, kinds);

        bool IsWrong(int i, int step) => i + step >= 0 && i + step < difference.Pixels && (Math.Abs(step) != 1 || (i + step) / width == i / width)
            && difference.IsWrong(i + step);
    }
}
