namespace RayCaster.Engine;

/// <summary>The sizes of tiles and strips.</summary>
internal static class Tile
{
    /// <summary>The most columns and rows of a tile; no tile crosses a multiple of it.</summary>
    public const int MaxSide = 64;

    /// <summary>The most columns of a strip, which is the row of tiles that a thread takes at once.</summary>
    public const int MaxStrip = RegionPacket.Count * MaxSide;

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
}
