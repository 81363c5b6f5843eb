namespace RayCaster.Engine;

/// <summary>Eight parts of the picture, and all the rays of each as intervals: a part is a lane.</summary>
internal sealed class RegionPacket(Camera camera)
{
    public const int Count = 8;

    private readonly PixelRect[] tiles = new PixelRect[Count];
    private Ray<Interval> rays;
    private Interval depthPerT;
    private bool isAimed;

    /// <summary>A part; it may be empty.</summary>
    public ref readonly PixelRect this[int part] => ref tiles[part];

    /// <summary>How many parts lie side by side; the others lie above them.</summary>
    public int Across { get; private set; }

    /// <summary>The rays. They are computed on first use: meshes and batches do not need them, and their code takes long to compile.</summary>
    public ref readonly Ray<Interval> Rays
    {
        get
        {
            if (!isAimed) Aim();
            return ref rays;
        }
    }

    /// <summary>What z gains for one unit of t along the <see cref="Rays"/>, which must be read first.</summary>
    public ref readonly Interval DepthPerT => ref depthPerT;

    /// <summary>Cuts a rectangle into parts, from left to right and then upwards.</summary>
    /// <param name="whole">The rectangle; parts that lie beyond its sides are narrower, lower or empty.</param>
    /// <param name="across">How many lie side by side.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public void Cut(in PixelRect whole, int side, int across)
    {
        Across = across;
        for (var i = 0; i < Count; i++)
        {
            var (up, along) = Math.DivRem(i, across);
            var (column, row) = (Math.Min(along * side, whole.Width), Math.Min(up * side, whole.Height));
            tiles[i] = new(whole.Column + column, whole.Row + row, Math.Min(side, whole.Width - column), Math.Min(side, whole.Height - row));
        }
        isAimed = false;
    }

    private void Aim()
    {
        Span<double> left = stackalloc double[Count], right = stackalloc double[Count], bottom = stackalloc double[Count],
            top = stackalloc double[Count];
        for (var i = 0; i < Count; i++)
        {
            (left[i], bottom[i]) = (tiles[i].Column, tiles[i].Row);
            // of an empty part, any
            (right[i], top[i]) = (Math.Max(tiles[i].EndColumn - 1, tiles[i].Column), Math.Max(tiles[i].EndRow - 1, tiles[i].Row));
        }
        var direction = camera.Direction(Range(left, right), Range(bottom, top));
        rays = new(camera.Position, direction);
        depthPerT = camera.DepthPerT(direction);
        isAimed = true;
    }

    private static Interval Range(ReadOnlySpan<double> lo, ReadOnlySpan<double> hi) =>
        new(new WidePacket(Vector512.Create(lo)), new WidePacket(Vector512.Create(hi)));
}
