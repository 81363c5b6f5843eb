namespace RayCaster;

/// <summary>A rectangle of pixels that is worked on at once.</summary>
/// <param name="Column">The first column, from the left.</param>
/// <param name="Row">The lowest row, from the bottom.</param>
/// <param name="Width">Columns.</param>
/// <param name="Height">Rows.</param>
internal readonly record struct Tile(int Column, int Row, int Width, int Height)
{
    /// <summary>The most columns and rows of a tile.</summary>
    public const int MaxSide = 64;

    /// <summary>The column after the last.</summary>
    public int EndColumn => Column + Width;

    /// <summary>The row above the topmost.</summary>
    public int EndRow => Row + Height;

    /// <summary>Whether the tiles share a pixel.</summary>
    public bool Overlaps(in Tile other) =>
        Column < other.EndColumn && other.Column < EndColumn && Row < other.EndRow && other.Row < EndRow;
}
