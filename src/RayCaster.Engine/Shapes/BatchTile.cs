namespace RayCaster.Engine;

/// <summary>A part of the picture in which members of a batch are looked for: its rays, the nearest hits so far, and what they hide. Each thread has
/// its own.</summary>
/// <remarks>Most members are hidden, wholly or in part, and branch prediction cannot tell where. So for some members at a time, the packets that a
/// formula must test are listed first, without branches, and then computed without any.</remarks>
internal sealed class BatchTile<N>(Camera camera) where N : struct, IPacket<N>
{
    private const int Side = ScreenBins.PartSide;

    private const int BlockSide = 8, BlocksAcross = Side / BlockSide, Blocks = BlocksAcross * BlocksAcross;

    private const int MaxListed = Blocks * BlockSide * BlockSide / 4 * DepthOrder.Batch;

    private readonly int[] packets = new int[MaxListed], members = new int[MaxListed];
    private readonly double[] farthest = new double[Blocks]; // the greatest t of the nearest hits in each block
    private Tile tile;
    private Sides sides;
    private int count;
    private uint touched; // the blocks whose farthest hit may have changed

    /// <summary>Its rays, and the nearest hits so far.</summary>
    public RayStream Rays { get; } = new(camera, Side * Side);

    public void Enter(in Tile tile)
    {
        touched = (1u << Blocks) - 1; // until Refresh, nothing is known of any block
        (this.tile, sides) = (tile, new(tile));
        Rays.Enter<N>(tile.Column, tile.Width, Side);
        Rays.Aim<N>(tile.Row, tile.Height);
        for (var i = 0; i < Side; i++) // what lies beyond the picture is hidden
        {
            var width = i < tile.Height ? tile.Width : 0;
            if (width < Side) Rays.Hide(i * Side + width, Side - width);
        }
    }

    public void Take(RayStream rays)
    {
        var row = (rays.Row - tile.Row) * Side;
        for (var i = 0; i < tile.Width; i += N.Count) Rays.Set(row + i, rays.NearestAt<N>(i), rays.ModelsAt<N>(i));
        if (tile.Width < Side) Rays.Hide(row + tile.Width, Side - tile.Width);
    }

    /// <summary>Whether all pixels have a hit nearer than this.</summary>
    public bool Hides(double nearest) => Visible(nearest) == 0;

    /// <summary>Clears the list of packets and finds the farthest hit of each block that they changed.</summary>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    public void Refresh()
    {
        for (; touched != 0; touched &= touched - 1) FindFarthest(BitOperations.TrailingZeroCount(touched));
        count = 0;
    }

    /// <summary>Lists the packets in a member's rectangle that do not hide it.</summary>
    /// <param name="index">Its index among all members.</param>
    /// <returns>The end of the list.</returns>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    public int List(in BatchItem member, int index)
    {
        var nearest = member.Nearest;
        var shared = sides.And(member.Sides);
        var (left, right) = (shared.Left - tile.Column, shared.Right - 1 - tile.Column);
        var (bottom, top) = (shared.Bottom - tile.Row, shared.Top - 1 - tile.Row);
        var columns = (2u << (right / BlockSide)) - (1u << (left / BlockSide)); // a bit for each block
        var rows = (uint)((2UL << top) - (1UL << bottom));                      // a bit for each row
        var inRows = (2u << (top / BlockSide)) - (1u << (bottom / BlockSide));
        var blocks = columns * ((inRows | inRows << 3 | inRows << 6 | inRows << 9) & 0x1111) & Visible(nearest);
        touched |= blocks;
        var least = Lanes.Broadcast<N>(nearest);
        var (rays, packets, members, end) = (Rays, this.packets, this.members, count);
        for (; blocks != 0; blocks &= blocks - 1)
        {
            var block = BitOperations.TrailingZeroCount(blocks);
            var i = Corner(block);
            var inBlock = rows >> (block / BlocksAcross * BlockSide);
            for (var y = 0; y < BlockSide; y++, i += Side, inBlock >>= 1)
            {
                for (var x = 0; x < BlockSide; x += N.Count)
                {
                    packets[end] = i + x;
                    members[end] = index;
                    end += (Lanes.All(rays.NearestAt<N>(i + x) < least) ? 0 : 1) & (int)inBlock;
                }
            }
        }
        return count = end;
    }

    /// <summary>The first pixel of each listed packet.</summary>
    public ReadOnlySpan<int> Packets => packets;

    /// <summary>The member that each listed packet may hit.</summary>
    public ReadOnlySpan<int> Members => members;

    /// <summary>A bit for each block in which some pixel's nearest hit is not nearer than this.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private uint Visible(double nearest)
    {
        var (least, bits) = (Lanes.Broadcast<N>(nearest), 0u);
        for (var i = 0; i < Blocks; i += N.Count) bits |= N.Bits(N.Load(farthest, i) >= least) << i;
        return bits;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void FindFarthest(int block)
    {
        var i = Corner(block);
        var most = Rays.NearestAt<N>(i);
        for (var x = 0; x < BlockSide; x += N.Count)
            for (var y = 0; y < BlockSide * Side; y += Side)
                most = N.Max(most, Rays.NearestAt<N>(i + x + y));
        farthest[block] = N.Greatest(most);
    }

    /// <summary>The first pixel of a block.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static int Corner(int block) => block / BlocksAcross * BlockSide * Side + block % BlocksAcross * BlockSide;
}
