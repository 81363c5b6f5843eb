namespace RayCaster;

/// <summary>A tile, and all its rays at once, as intervals.</summary>
internal sealed class TileRays(Camera camera)
{
    /// <summary>The tile.</summary>
    public Tile Tile { get; private set; }

    /// <summary>The rays.</summary>
    public Ray<Interval> Rays { get; private set; }

    /// <summary>What z gains for one unit of t.</summary>
    public Interval ZPerT { get; private set; }

    /// <summary>Goes to another tile.</summary>
    public void Aim(in Tile tile)
    {
        Tile = tile;
        var direction = camera.Direction(new Interval(tile.Column, tile.EndColumn - 1), new Interval(tile.Row, tile.EndRow - 1));
        Rays = new(camera.Position, direction);
        ZPerT = camera.ZPerT(direction);
    }
}
