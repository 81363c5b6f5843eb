namespace RayCaster.Teaching.Comparison;

/// <summary>How many lines and columns a picture lacks at each side, and is right but for that.</summary>
internal sealed record Crop(int Left, int Top, int Right, int Bottom)
{
    /// <summary>So many lines and columns may be missing.</summary>
    private const int Most = 16;

    /// <summary>How many pixels are looked at before all are.</summary>
    private const int Samples = 200;

    /// <summary>What is missing, for a sentence: <c>its first line and its last column</c>.</summary>
    public string CroppedPart => string.Join(" and ", ((string?[])
    [
        Some(Top, "first", "line"), Some(Bottom, "last", "line"), Some(Left, "first", "column"), Some(Right, "last", "column"),
    ]).OfType<string>());

    /// <summary>Whether a picture can be a part of one of a size.</summary>
    public static bool IsPossible(Picture mine, int width, int height) =>
        width - mine.Width is >= 0 and <= Most && height - mine.Height is >= 0 and <= Most
        && (mine.Width, mine.Height) != (width, height) && !mine.IsOneColor;

    /// <summary>What a picture lacks of the right one; null if the rest is not right.</summary>
    public static Crop? Find(Picture mine, Picture reference)
    {
        if (!IsPossible(mine, reference.Width, reference.Height)) return null;
        var columns = reference.Width - mine.Width;
        var lines = reference.Height - mine.Height;
        var places = new GoldenRatioSequence(mine.Count);
        (Crop Crop, int Wrong)? best = null;
        for (var top = 0; top <= lines; top++)
        {
            for (var left = 0; left <= columns; left++)
            {
                var (across, down) = (left, top);
                var misses = Enumerable.Range(0, Samples).Select(i => places[i]).Count(place =>
                    !PictureJudge.IsNear(mine.At(place), reference[place % mine.Width + across, place / mine.Width + down]));
                if (misses > Samples / 20) continue;
                var part = Picture.Create(mine.Width, mine.Height, (x, y) => reference[x + across, y + down]);
                var difference = new PictureDifference(mine, part);
                if (new PictureJudge(part).Compare(difference) != Likeness.Wrong && !(best?.Wrong <= difference.Wrong))
                    best = (new(left, top, columns - left, lines - top), difference.Wrong);
            }
        }
        return best?.Crop;
    }

    private static string? Some(int count, string which, string what) =>
        count switch { 0 => null, 1 => $"its {which} {what}", _ => $"its {which} {count} {what}s" };
}
