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

    /// <summary>How many strips cover this many columns.</summary>
    public static int StripsOf(int pixels) => (pixels + MaxStrip - 1) / MaxStrip;

    /// <summary>Whether the tiles share a pixel.</summary>
    public bool Overlaps(in Tile other) =>
        Column < other.EndColumn && other.Column < EndColumn && Row < other.EndRow && other.Row < EndRow;

    /// <summary>The pixels where something within bounds may show; empty if the bounds are behind the camera.</summary>
    /// <remarks>The bounds are padded by far more than a formula's rounding can move a hit sideways (<see cref="BoundsExtensions.PaddedFrom"/>). The
    /// projection itself rounds by some 1e-15 of the picture's size, less than 1e-9 of a pixel, against a margin of a hundredth.</remarks>
    /// <param name="padded">The bounds relative to the camera, padded.</param>
    /// <param name="margin">Pixels to be added on each side.</param>
    public static Tile Of(Bounds padded, Camera camera, double margin = 0.01)
    {
        if (camera.IsSkewed) return Everywhere; // the projection would be wrong
        var (center, half) = (0.5 * (padded.Min + padded.Max), 0.5 * (padded.Max - padded.Min));
        var (depth, depthHalf) = (-(center * camera.W), Spread(camera.W));
        var (nearest, farthest) = (depth - depthHalf, depth + depthHalf);
        if (farthest < 0) return default;
        if (!(nearest > 0)) return Everywhere; // it reaches the eye's plane, or is NaN

        var (column, endColumn) = Pixels(center * camera.U, Spread(camera.U), camera.PlaneWidth, camera.Width);
        var (row, endRow) = Pixels(center * camera.V, Spread(camera.V), camera.PlaneHeight, camera.Height);
        return column < endColumn && row < endRow ? new(column, row, endColumn - column, endRow - row) : default;

        double Spread(Vector3 axis) => Math.Abs(axis.X) * half.X + Math.Abs(axis.Y) * half.Y + Math.Abs(axis.Z) * half.Z;

        (int First, int End) Pixels(double middle, double spread, double planeSize, int pixels)
        {
            var (least, most) = (middle - spread, middle + spread);
            var first = least / (least < 0 ? nearest : farthest);
            var last = most / (most < 0 ? farthest : nearest);
            return (Pixel(first, -margin), Pixel(last, 1 + margin));

            // The sample of pixel c lies at u = planeSize · c / pixels − planeSize / 2, half a pixel further for centres.
            int Pixel(double u, double beyond)
            {
                var c = (u / planeSize + 0.5) * pixels - camera.SampleOffset;
                if (double.IsNaN(c)) return beyond < 0 ? 0 : pixels;
                return (int)Math.Clamp(beyond < 0 ? Math.Ceiling(c + beyond) : Math.Floor(c + beyond), 0, pixels);
            }
        }
    }
}
