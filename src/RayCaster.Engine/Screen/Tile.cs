namespace RayCaster.Engine;

/// <summary>A rectangle of pixels.</summary>
/// <param name="Column">The first column, from the left.</param>
/// <param name="Row">The lowest row, from the bottom.</param>
public readonly record struct Tile(int Column, int Row, int Width, int Height)
{
    /// <summary>The most columns and rows of a tile; no tile crosses a multiple of it.</summary>
    public const int MaxSide = 64;

    /// <summary>The most columns of a strip, which is the row of tiles that a thread takes at once.</summary>
    public const int MaxStrip = EightParts.Count * MaxSide;

    /// <summary>Larger than any picture.</summary>
    public static Tile Everywhere => new(0, 0, int.MaxValue, int.MaxValue);

    /// <summary>The column after the last.</summary>
    public int EndColumn => Column + Width;

    /// <summary>The row above the topmost.</summary>
    public int EndRow => Row + Height;

    /// <summary>How many pixels; 0 for an empty tile.</summary>
    public long Area => (long)Width * Height;

    /// <summary>How many tiles cover this many columns or rows.</summary>
    public static int TilesOf(int pixels) => (pixels + MaxSide - 1) / MaxSide;

    /// <summary>How many columns of a picture a thread takes at once: fewer tiles side by side if strips are few, so that all threads
    /// have work until the end.</summary>
    /// <param name="tilesUp">How many tiles lie above each other.</param>
    public static int StripWidth(int width, long tilesUp, int threads)
    {
        const int StripsOfThread = 4;
        var strip = MaxStrip;
        while (threads > 1 && strip > MaxSide && (width + strip - 1) / strip * tilesUp < StripsOfThread * (long)threads) strip /= 2;
        return strip;
    }

    /// <summary>Whether the tiles share a pixel.</summary>
    public bool Overlaps(in Tile other) =>
        Column < other.EndColumn && other.Column < EndColumn && Row < other.EndRow && other.Row < EndRow;
}
