namespace RayCaster.Teaching;

/// <summary>How well a picture agrees with the one that it should be, from right to wrong.</summary>
public enum Likeness
{
    /// <summary>Every byte is equal.</summary>
    Identical,

    /// <summary>No channel differs by more than 1 level, and at most 1 % of the pixels differ: the last bits of doubles can cause that.</summary>
    WithinRounding,

    /// <summary>Also, some pixels on outlines show the other side of the outline: the last bits of doubles can cause that, too.</summary>
    OutlinesOnly,

    /// <summary>Except on outlines, no channel differs by more than 1 level, but more than 1 % of the pixels differ: bytes are not rounded to
    /// nearest.</summary>
    RoundedOtherwise,

    /// <summary>Anything else.</summary>
    Wrong,
}

/// <summary>Decides which <see cref="Likeness"/> a difference is.</summary>
public static class Likenesses
{
    /// <summary>Whether the picture is right: two correct programs can differ by as much.</summary>
    public static bool IsSame(this Likeness verdict) => verdict <= Likeness.OutlinesOnly;

    /// <param name="holdAllWrong">Whether all pixels that differ by more than rounding are on outlines.</param>
    internal static Likeness Of(PictureDifference difference, Func<PictureDifference, bool> holdAllWrong)
    {
        if (difference.Largest == 0) return Likeness.Identical;
        if (difference.Wrong > 0 && !holdAllWrong(difference)) return Likeness.Wrong;
        if (difference.OffByOne > difference.Pixels / 100) return Likeness.RoundedOtherwise;
        return difference.Wrong == 0 ? Likeness.WithinRounding : Likeness.OutlinesOnly;
    }
}
