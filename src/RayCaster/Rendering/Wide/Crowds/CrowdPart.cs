using System.Runtime.CompilerServices;

namespace RayCaster;

/// <summary>One thread's part of the picture in which members of a crowd are looked for, and the nearest hits there so far.</summary>
internal sealed class CrowdPart
{
    /// <summary>The most columns and rows. Its rays and hits, 48 bytes a pixel, should stay in the first-level cache.</summary>
    public const int Side = 32;

    /// <summary>After how many questions the farthest hit is looked for anew.</summary>
    private const int Patience = 8;

    private double farthest;
    private int patience;

    public CrowdPart(Camera camera)
    {
        Rays = new(camera);
        for (var i = 0; i < Side; i++) Rows[i] = new(camera);
    }

    /// <summary>Its pixels.</summary>
    public Tile Tile { get; private set; }

    /// <summary>All its rays at once.</summary>
    public TileRays Rays { get; }

    /// <summary>Its rays, row by row.</summary>
    public RaySpan[] Rows { get; } = new RaySpan[Side];

    /// <summary>Goes to a part and forgets all hits.</summary>
    public void Enter<N>(in Tile tile) where N : struct, IPacket<N>
    {
        (Tile, farthest, patience) = (tile, double.PositiveInfinity, 0);
        Rays.Aim(tile);
        for (var i = 0; i < tile.Height; i++)
        {
            Rows[i].Enter<N>(tile.Column, tile.Width);
            Rows[i].Aim<N>(tile.Row + i);
        }
    }

    /// <summary>Whether all pixels have a hit nearer than this; asked once for each member.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Hides<N>(double nearest) where N : struct, IPacket<N>
    {
        if (--patience < 0) FindFarthest<N>();
        return nearest > farthest;
    }

    /// <summary>The same for a range of hits.</summary>
    public bool Hides(Interval hit) => hit.Lo > farthest; // so is nothing, from +∞ on

    [MethodImpl(MethodImplOptions.AggressiveOptimization | MethodImplOptions.NoInlining)]
    private void FindFarthest<N>() where N : struct, IPacket<N>
    {
        patience = Patience;
        farthest = Rows[0].Farthest<N>();
        for (var i = 1; i < Tile.Height && farthest < double.PositiveInfinity; i++) farthest = Math.Max(farthest, Rows[i].Farthest<N>());
    }
}
