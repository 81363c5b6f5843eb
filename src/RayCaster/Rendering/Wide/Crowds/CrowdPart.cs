using System.Runtime.CompilerServices;

namespace RayCaster;

/// <summary>One thread's part of the picture in which members of a crowd are looked for: its rays, and the nearest hits so far.</summary>
/// <remarks>
/// The numbers of row y begin at y · Side. Most members that are looked at are hidden, wholly or in part, and it cannot be foretold where: so the packets
/// to ask the formula about are listed first, without a branch, and then asked without one.
/// </remarks>
internal sealed class CrowdPart(Camera camera)
{
    /// <summary>The most columns and rows. Its rays and hits, 48 bytes a pixel, should stay in the first-level cache.</summary>
    public const int Side = 32;

    /// <summary>After how many questions the farthest hit is looked for anew.</summary>
    private const int Patience = 8;

    private readonly int[] packets = new int[Side * Side + 1];
    private Tile tile;
    private double farthest;
    private int patience;

    /// <summary>All its rays at once.</summary>
    public TileRays AllRays { get; } = new(camera);

    /// <summary>Its rays.</summary>
    public CrowdRays Rays { get; } = new(camera.Position);

    /// <summary>The nearest hits so far.</summary>
    public CrowdHits Hits { get; } = new();

    /// <summary>Goes to another part.</summary>
    public void Enter(in Tile tile)
    {
        (this.tile, farthest, patience) = (tile, double.PositiveInfinity, 0);
        AllRays.Aim(tile);
    }

    /// <summary>Takes over the rays of a row, and their hits.</summary>
    public void Take<N>(RaySpan span) where N : struct, IPacket<N>
    {
        var row = (span.Row - tile.Row) * Side;
        for (var i = 0; i < tile.Width; i += N.Count)
        {
            Rays.Set(row + i, span.RaysAt<N>(i).Direction, span.ZPerTAt<N>(i));
            Hits.Set(row + i, span.NearestAt<N>(i), span.ModelsAt<N>(i));
        }
    }

    /// <summary>Gives the hits of a row back.</summary>
    public void Give<N>(RaySpan span) where N : struct, IPacket<N>
    {
        var row = (span.Row - tile.Row) * Side;
        for (var i = 0; i < tile.Width; i += N.Count) span.Set(i, Hits.NearestAt<N>(row + i), Hits.ModelsAt<N>(row + i));
    }

    /// <summary>Whether a good part of the pixels lies in a member's rectangle.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool IsMostlyCoveredBy(in CrowdMember member) =>
        2 * (Math.Min(member.Right, tile.EndColumn) - Math.Max(member.Left, tile.Column)) > Side
        && 2 * (Math.Min(member.Top, tile.EndRow) - Math.Max(member.Bottom, tile.Row)) > Side;

    /// <summary>The packets in a member's rectangle where not all hits so far are nearer than it.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public ReadOnlySpan<int> PacketsOf<N>(in CrowdMember member) where N : struct, IPacket<N>
    {
        var (first, end) = (Math.Max(member.Left - tile.Column, 0) / N.Count * N.Count, Math.Min(member.Right, tile.EndColumn) - tile.Column);
        var (row, endRow) = (Math.Max(member.Bottom - tile.Row, 0) * Side, (Math.Min(member.Top, tile.EndRow) - tile.Row) * Side);
        var nearest = RaySpan.All<N>(member.Nearest);
        var (count, hits, packets) = (0, Hits, this.packets);
        for (; row < endRow; row += Side)
        {
            for (var i = row + first; i < row + end; i += N.Count)
            {
                packets[count] = i;
                count += N.All(hits.NearestAt<N>(i) < nearest) ? 0 : 1;
            }
        }
        return packets.AsSpan(0, count);
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
        var most = RaySpan.All<N>(0);
        for (var row = 0; row < tile.Height * Side; row += Side)
            for (var i = row; i < row + tile.Width; i += N.Count)
                most = N.Max(most, Hits.NearestAt<N>(i));
        farthest = N.Greatest(most);
    }
}

/// <summary>The rays of a part; the numbers of each row begin at a multiple of <see cref="CrowdPart.Side"/>.</summary>
internal readonly struct CrowdRays(Vector3 origin)
{
    private readonly Vector3 origin = origin;
    private readonly double[] x = new double[Length], y = new double[Length], z = new double[Length], zPerT = new double[Length];

    private const int Length = CrowdPart.Side * CrowdPart.Side;

    /// <summary>The rays of a packet.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Ray<N> At<N>(int packet) where N : struct, IPacket<N> =>
        new(origin, new Vector3<N>(N.Load(x, packet), N.Load(y, packet), N.Load(z, packet)));

    /// <summary>What their z gains for one unit of t.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public N ZPerTAt<N>(int packet) where N : struct, IPacket<N> => N.Load(zPerT, packet);

    /// <summary>Sets both.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Set<N>(int packet, Vector3<N> direction, N zPerT) where N : struct, IPacket<N>
    {
        direction.X.Store(x, packet);
        direction.Y.Store(y, packet);
        direction.Z.Store(z, packet);
        zPerT.Store(this.zPerT, packet);
    }
}

/// <summary>The nearest hits of these rays so far.</summary>
internal readonly struct CrowdHits()
{
    private readonly double[] t = new double[CrowdPart.Side * CrowdPart.Side], models = new double[CrowdPart.Side * CrowdPart.Side];

    /// <summary>The t of a packet's hits.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public N NearestAt<N>(int packet) where N : struct, IPacket<N> => N.Load(t, packet);

    /// <summary>Their models.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public N ModelsAt<N>(int packet) where N : struct, IPacket<N> => N.Load(models, packet);

    /// <summary>Sets both.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Set<N>(int packet, N nearest, N model) where N : struct, IPacket<N>
    {
        nearest.Store(t, packet);
        model.Store(models, packet);
    }

    /// <summary>Keeps the hits of a model that are nearer than all before; see <see cref="RaySpan.Keep"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Keep<N>(int packet, N hit, N model) where N : struct, IPacket<N>
    {
        var (nearest, first) = (NearestAt<N>(packet), ModelsAt<N>(packet));
        var better = (hit < nearest) | (N.Equal(hit, nearest) & (model < first));
        Set(packet, N.Select(better, hit, nearest), N.Select(better, model, first));
    }
}
