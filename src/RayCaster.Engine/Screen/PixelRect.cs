namespace RayCaster.Engine;

/// <summary>A rectangle of pixels.</summary>
/// <param name="Column">The first column, from the left.</param>
/// <param name="Row">The lowest row, from the bottom.</param>
internal readonly record struct PixelRect(int Column, int Row, int Width, int Height)
{
    /// <summary>Larger than any picture.</summary>
    public static PixelRect Everywhere => new(0, 0, int.MaxValue, int.MaxValue);

    public int EndColumn => Column + Width;

    public int EndRow => Row + Height;

    public long Area => (long)Width * Height;

    /// <summary>Whether the rectangles share a pixel. It takes no branch, since of many rectangles the answer is unpredictable.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Overlaps(in PixelRect other) =>
        Column < other.EndColumn & other.Column < EndColumn & Row < other.EndRow & other.Row < EndRow;
}
