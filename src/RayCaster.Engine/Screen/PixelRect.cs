namespace RayCaster.Engine;

/// <summary>A rectangle of pixels.</summary>
/// <param name="Column">The first column, from the left.</param>
/// <param name="Row">The lowest row, from the bottom.</param>
public readonly record struct PixelRect(int Column, int Row, int Width, int Height)
{
    /// <summary>Larger than any picture.</summary>
    public static PixelRect Everywhere => new(0, 0, int.MaxValue, int.MaxValue);

    /// <summary>The column after the last.</summary>
    public int EndColumn => Column + Width;

    /// <summary>The row above the topmost.</summary>
    public int EndRow => Row + Height;

    /// <summary>How many pixels; 0 for an empty rectangle.</summary>
    public long Area => (long)Width * Height;

    /// <summary>Whether the rectangles share a pixel. It takes no branch, since of many rectangles the answer is unpredictable.</summary>
    public bool Overlaps(in PixelRect other) =>
        Column < other.EndColumn & other.Column < EndColumn & Row < other.EndRow & other.Row < EndRow;
}
