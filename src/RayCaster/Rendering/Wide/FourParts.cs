using System.Runtime.Intrinsics;

namespace RayCaster;

/// <summary>Four parts of the picture, and all the rays of each as intervals: a part is a lane.</summary>
internal sealed class FourParts(Camera camera)
{
    /// <summary>How many.</summary>
    public const int Count = 4;

    private readonly Tile[] tiles = new Tile[Count];
    private bool isAimed;

    /// <summary>One of them; it may be empty.</summary>
    public ref readonly Tile this[int part] => ref tiles[part];

    /// <summary>The rays; found when they are asked for first, for a mesh or a crowd does not, and they are the longest formula there is to compile.</summary>
    public Ray<Interval<Packet>> Rays
    {
        get
        {
            if (!isAimed) Aim();
            return field;
        }
        private set;
    }

    /// <summary>What z gains for one unit of t along the <see cref="Rays"/> that were asked for.</summary>
    public Interval<Packet> ZPerT { get; private set; }

    /// <summary>Goes to the quarters of a part.</summary>
    public void Quarter(in Tile part)
    {
        var (width, height) = (Half(part.Width), Half(part.Height));
        tiles[0] = new(part.Column, part.Row, width, height);
        tiles[1] = new(part.Column + width, part.Row, part.Width - width, height);
        tiles[2] = new(part.Column, part.Row + height, width, part.Height - height);
        tiles[3] = new(part.Column + width, part.Row + height, part.Width - width, part.Height - height);
        isAimed = false;
    }

    /// <summary>Goes to the tiles of a strip.</summary>
    /// <param name="strip">Some tiles side by side.</param>
    public void Split(in Tile strip)
    {
        for (var i = 0; i < Count; i++)
        {
            var left = Math.Min(i * Tile.MaxSide, strip.Width);
            tiles[i] = new(strip.Column + left, strip.Row, Math.Min(Tile.MaxSide, strip.Width - left), strip.Height);
        }
        isAimed = false;
    }

    private void Aim()
    {
        Span<double> left = stackalloc double[Count], right = stackalloc double[Count], bottom = stackalloc double[Count], top = stackalloc double[Count];
        for (var i = 0; i < Count; i++)
        {
            (left[i], bottom[i]) = (tiles[i].Column, tiles[i].Row);
            (right[i], top[i]) = (Math.Max(tiles[i].EndColumn - 1, tiles[i].Column), Math.Max(tiles[i].EndRow - 1, tiles[i].Row)); // of an empty one, any
        }
        var direction = camera.Direction(Range(left, right), Range(bottom, top));
        Rays = new(camera.Position, direction);
        ZPerT = camera.ZPerT(direction);
        isAimed = true;
    }

    private static Interval<Packet> Range(ReadOnlySpan<double> lo, ReadOnlySpan<double> hi) =>
        new(new Packet(Vector256.Create(lo)), new Packet(Vector256.Create(hi)));

    /// <summary>Half of a length, in whole packets of the widest kind.</summary>
    private static int Half(int length) => length <= RoughPacket.Count ? length : (length / 2 + RoughPacket.Count - 1) / RoughPacket.Count * RoughPacket.Count;
}

/// <summary>Where the hits of a model in four parts lie (<see cref="Reach"/>), a lane for each.</summary>
internal readonly struct Reaches(Packet least, Packet cover, Packet isNear)
{
    /// <summary>The same in all parts.</summary>
    public Reaches(Reach all) : this(all.Least, all.Cover, 0) { }

    /// <summary>That of a part.</summary>
    public Reach this[int part] => new(least.Lanes[part], cover.Lanes[part], double.IsNegative(isNear.Lanes[part])); // a mask's sign is its truth
}
