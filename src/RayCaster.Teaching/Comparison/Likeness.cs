namespace RayCaster.Teaching.Comparison;

/// <summary>How well a picture agrees with the right one, from right to wrong.</summary>
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

/// <summary>What a <see cref="Likeness"/> means.</summary>
public static class Likenesses
{
    /// <summary>Whether the picture is right: two correct programs can differ by as much.</summary>
    public static bool IsSame(this Likeness verdict) => verdict <= Likeness.OutlinesOnly;
}
