namespace RayCaster.Teaching.Comparison;

/// <summary>
/// The eight ways to turn and mirror a picture. Half is a turn by 180°; transposing makes lines of columns, and the upper left corner stays, or in
/// AntiTransposed the upper right one.
/// </summary>
internal enum Turn
{
    None, TopBottom, LeftRight, Half,
    Transposed, Clockwise, CounterClockwise, AntiTransposed, // these swap width and height
}

/// <summary>Where a pixel of a turned picture comes from, as an index in reading order: Start + x · Right + y · Down.</summary>
/// <param name="Start">The index that the upper left pixel comes from.</param>
internal readonly record struct TurnedIndices(int Start, int Right, int Down)
{
    public static bool SwapsSides(Turn turn) => turn >= Turn.Transposed;

    /// <param name="width">Its width before the turn.</param>
    /// <param name="height">Its height before the turn.</param>
    public static TurnedIndices Create(Turn turn, int width, int height)
    {
        var last = width * height - 1;
        return turn switch
        {
            Turn.None => new(0, 1, width),
            Turn.TopBottom => new(last - width + 1, 1, -width),
            Turn.LeftRight => new(width - 1, -1, width),
            Turn.Half => new(last, -1, -width),
            Turn.Transposed => new(0, width, 1),
            Turn.Clockwise => new(last - width + 1, -width, 1),
            Turn.CounterClockwise => new(width - 1, width, -1),
            _ => new(last, -width, -1),
        };
    }
}
