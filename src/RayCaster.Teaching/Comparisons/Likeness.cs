namespace RayCaster.Teaching;

/// <summary>How a picture stands to the one that it should be, from right to wrong.</summary>
public enum Likeness
{
    /// <summary>Every byte is equal.</summary>
    Identical,

    /// <summary>No channel differs by more than 1 level, and at most 1 % of the pixels differ: the last bits of a double may do that.</summary>
    WithinRounding,

    /// <summary>Besides, some pixels on outlines show the other side of the outline, which the last bits may do as well.</summary>
    OutlinesOnly,

    /// <summary>Outlines aside nothing differs by more than 1 level, but more than 1 % of the pixels do: bytes are not rounded to nearest.</summary>
    RoundedOtherwise,

    /// <summary>Anything else.</summary>
    Wrong,
}

/// <summary>What follows from a <see cref="Likeness"/>.</summary>
public static class Likenesses
{
    /// <summary>Whether the picture is as right as two programs written apart from each other can make it.</summary>
    public static bool IsSame(this Likeness verdict) => verdict <= Likeness.OutlinesOnly;

    /// <summary>The verdict on a difference.</summary>
    /// <param name="difference">The difference.</param>
    /// <param name="outlines">What tells pixels on outlines.</param>
    internal static Likeness Of(PictureDifference difference, IOutlines outlines)
    {
        if (difference.Largest == 0) return Likeness.Identical;
        if (difference.Wrong > 0 && !outlines.HoldAllWrong(difference)) return Likeness.Wrong;
        if (difference.OffByOne > difference.Pixels / 100) return Likeness.RoundedOtherwise;
        return difference.Wrong == 0 ? Likeness.WithinRounding : Likeness.OutlinesOnly;
    }
}
