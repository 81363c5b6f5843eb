namespace RayCaster.Teaching;

/// <summary>The eight ways to turn and mirror a picture.</summary>
public enum Turn
{
    /// <summary>As it is.</summary>
    None,

    /// <summary>The top line becomes the bottom one.</summary>
    TopBottom,

    /// <summary>Mirrored: the left column becomes the right one.</summary>
    LeftRight,

    /// <summary>Turned by 180°.</summary>
    Half,

    /// <summary>Columns become lines: the upper left corner stays where it is.</summary>
    Transposed,

    /// <summary>Turned by 90° clockwise.</summary>
    Clockwise,

    /// <summary>Turned by 90° counter-clockwise, which is 270° clockwise.</summary>
    CounterClockwise,

    /// <summary>Columns become lines: the upper right corner stays where it is.</summary>
    AntiTransposed,
}

/// <summary>Where a pixel of a turned picture comes from, as a place in reading order: Start + x · Right + y · Down.</summary>
/// <param name="Start">The place that the upper left pixel comes from.</param>
/// <param name="Right">The step of the place for a step to the right.</param>
/// <param name="Down">The step of the place for a step down.</param>
internal readonly record struct TurnedPlaces(int Start, int Right, int Down)
{
    /// <summary>Whether the turn swaps width and height.</summary>
    public static bool SwapsSides(Turn turn) => turn >= Turn.Transposed;

    /// <param name="width">Its width before the turn.</param>
    /// <param name="height">Its height before the turn.</param>
    public static TurnedPlaces Of(Turn turn, int width, int height)
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
            Turn.AntiTransposed => new(last, -width, -1),
            _ => throw new ArgumentOutOfRangeException(nameof(turn), turn, null),
        };
    }
}
