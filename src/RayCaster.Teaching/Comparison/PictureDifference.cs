namespace RayCaster.Teaching.Comparison;

/// <summary>Where two pictures of the same size differ, and by how many levels: a level is 1 of the 255 of a channel.</summary>
public sealed class PictureDifference
{
    private readonly byte[] levels;
    private readonly int[] count = new int[256]; // of pixels by their levels

    /// <summary>Compares all pixels.</summary>
    /// <exception cref="ArgumentException">The sizes differ.</exception>
    public PictureDifference(Picture mine, Picture reference)
    {
        if ((mine.Width, mine.Height) != (reference.Width, reference.Height))
            throw new ArgumentException(
                $"a picture of {mine.Width} x {mine.Height} pixels beside one of {reference.Width} x {reference.Height}", nameof(mine));
        (Mine, Reference) = (mine, reference);
        levels = new byte[mine.Width * mine.Height];
        for (var pixel = 0; pixel < levels.Length; pixel++) Count(pixel);
        Largest = Array.FindLastIndex(count, pixels => pixels > 0);
    }

    /// <summary>The picture in question.</summary>
    public Picture Mine { get; }

    /// <summary>The one that it should be.</summary>
    public Picture Reference { get; }

    /// <summary>How many pixels a picture has.</summary>
    public int Pixels => levels.Length;

    /// <summary>Pixels that differ by 1 level: rounding.</summary>
    public int OffByOne => count[1];

    /// <summary>Those of <see cref="OffByOne"/> with no channel lighter than it should be, as truncation makes them.</summary>
    public int OneDarker { get; private set; }

    /// <summary>Pixels in which a channel differs by more than 1 level.</summary>
    public int Wrong => CountBeyond(1);

    /// <summary>The mean of the absolute differences of all channels, in levels (MAE).</summary>
    public double MeanAbsoluteError => Mine.Rgb.Zip(Reference.Rgb, (a, b) => (long)Math.Abs(a - b)).Sum() / (double)Mine.Rgb.Length;

    /// <summary>The largest difference of a channel anywhere.</summary>
    public int Largest { get; }

    /// <summary>
    /// The pixel in the middle of the widest wrong area. It is as far from right pixels as possible, so it is not on an outline. Null if no pixel
    /// differs by more than rounding.
    /// </summary>
    public (int X, int Y)? WrongMiddle => WrongArea is null ? null : field ??= FindMiddle();

    /// <summary>
    /// The first and the last column and line, from the top, with a pixel that differs by more than rounding; null if there is none.
    /// </summary>
    public (int Left, int Top, int Right, int Bottom)? WrongArea { get; private set; }

    /// <summary>How many pixels differ by more than so many levels in a channel.</summary>
    public int CountBeyond(int levels) => count.Skip(levels + 1).Sum();

    /// <summary>The largest difference of a pixel's three channels, by its index in reading order.</summary>
    public int LevelsAt(int pixel) => levels[pixel];

    /// <summary>Whether a pixel differs by more than rounding, by its index in reading order.</summary>
    public bool IsWrong(int pixel) => levels[pixel] > PictureJudge.Tolerance;

    /// <summary>The largest difference of two colours' three channels.</summary>
    internal static int Levels((byte R, byte G, byte B) a, (byte R, byte G, byte B) b) =>
        Math.Max(Math.Abs(a.R - b.R), Math.Max(Math.Abs(a.G - b.G), Math.Abs(a.B - b.B)));

    private void Count(int pixel)
    {
        var (a, b) = (Mine.At(pixel), Reference.At(pixel));
        var largest = Levels(a, b);
        levels[pixel] = (byte)largest;
        count[largest]++;
        if (largest == 1 && a.R <= b.R && a.G <= b.G && a.B <= b.B) OneDarker++;
        if (largest <= 1) return;

        var (y, x) = Math.DivRem(pixel, Mine.Width);
        WrongArea = WrongArea is var (left, top, right, _) ? (Math.Min(left, x), top, Math.Max(right, x), y) : (x, y, x, y);
    }

    /// <summary>The middle one of the pixels that are farthest from right ones, in steps that may be diagonal.</summary>
    private (int X, int Y) FindMiddle()
    {
        var (width, height) = (Mine.Width, Mine.Height);
        var away = new int[levels.Length];
        for (var i = 0; i < away.Length; i++) away[i] = levels[i] > 1 ? 1 + Least(i, -1) : 0;
        for (var i = away.Length - 1; i >= 0; i--) away[i] = Math.Min(away[i], 1 + Least(i, 1));
        var farthest = away.Max();
        int[] all = [.. Enumerable.Range(0, away.Length).Where(i => away[i] == farthest)];
        var middle = all[all.Length / 2];
        return (middle % width, middle / width);

        // The least of the four neighbours before a pixel, or after it; beyond the border all is right.
        int Least(int i, int step)
        {
            var (x, y) = (i % width, i / width);
            if (x == 0 || x == width - 1 || y + step < 0 || y + step >= height) return 0;
            var other = i + step * width;
            return Math.Min(Math.Min(away[i + step], away[other]), Math.Min(away[other - 1], away[other + 1]));
        }
    }
}
