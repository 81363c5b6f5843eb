using System.Runtime.CompilerServices;

namespace RayCaster.Engine;

/// <summary>
/// One thread's tool: finds the tiles of a mesh's triangles, by the box around sixteen of them that follow one another. Where that box says
/// little, each triangle is looked at.
/// </summary>
internal sealed class ClusterSorter<N>(ScreenSpace screen, Vector3[] vertices, int[] indices, TriangleSorter each) where N : struct, IPacket<N>, IReal<N>
{
    /// <summary>The triangles of a group in more tiles than this are sorted one by one: they lie far from each other, or are large.</summary>
    private const int ManyTiles = 6;

    private readonly int tilesAcross = Tile.TilesOf(screen.Camera.Width);
    private readonly TriangleBoxes boxes = new(vertices, indices);
    private readonly BoxCorners lows = new(N.Count), highs = new(N.Count);
    private readonly double[] left = new double[N.Count], right = new double[N.Count];
    private readonly double[] bottom = new double[N.Count], top = new double[N.Count], most = new double[N.Count];
    private readonly int[] middles = new int[N.Count];
    private (uint Left, uint Right, uint Bottom, uint Top) extent = (int.MaxValue, 0, int.MaxValue, 0);

    /// <summary>Clusters by tile and side.</summary>
    public PooledList<(int Place, TriangleCluster Cluster)> Clusters { get; } = new();

    /// <summary>Where samples may be covered.</summary>
    public (int Left, int Right, int Bottom, int Top) Extent => ((int)extent.Left, (int)extent.Right, (int)extent.Bottom, (int)extent.Top);

    /// <summary>Takes triangles.</summary>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    public void Add(int first, int end)
    {
        Clusters.Reserve((end - first) / TriangleCluster.Length);
        for (; first < end; first += N.Count * TriangleCluster.Length)
        {
            for (var i = 0; i < N.Count; i++)
            {
                // Where fewer are left than there are lanes, the last group again.
                var begin = Math.Min(first + i * TriangleCluster.Length, (end - 1) / TriangleCluster.Length * TriangleCluster.Length);
                var (low, high) = boxes.Around(begin, Math.Min(begin + TriangleCluster.Length, end));
                lows.Set(i, low);
                highs.Set(i, high);
                middles[i] = Math.Min(begin + TriangleCluster.Length / 2, end - 1);
            }
            var ((fit, shows), sides) = (Project(), Facings());
            for (var i = 0; i < N.Count && first + i * TriangleCluster.Length < end; i++)
            {
                var (begin, bit) = (first + i * TriangleCluster.Length, 1u << i);
                if ((fit & bit) == 0) each.Add(begin, Math.Min(begin + TriangleCluster.Length, end));
                else if ((shows & bit) != 0) Place(begin, Math.Min(begin + TriangleCluster.Length, end), i, (int)(sides >> i) & 1);
            }
        }
    }

    /// <summary>The rectangles on the screen and the ranges of w of some boxes.</summary>
    /// <remarks>
    /// Rounding moves a rectangle's sides by some 2⁻⁵³ of (distance + size) / least depth, in units of the scale; the size is held below the least
    /// depth,
    /// and so that is less than <see cref="ScreenSpace.DoubleMargin"/>, by which the formula, too, may see a corner elsewhere.
    /// </remarks>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private (uint Fit, uint Shows) Project()
    {
        Vector3<N> eye = screen.Camera.Position;
        var (low, high) = (lows.Load<N>() - eye, highs.Load<N>() - eye);
        var (center, half) = ((N)0.5 * (low + high), (N)0.5 * (high - low));
        var (nearest, farthest) = Range(-screen.Camera.W, center, half);
        var (inverse, inverseFar) = ((N)1.0 / nearest, (N)1.0 / farthest);
        var (w0, w1) = ((N)screen.Unit * inverseFar, (N)screen.Unit * inverse);

        N fit = (nearest > half.X + half.Y + half.Z) & (w0 > (N)1e-29) & (w1 < (N)1e29), shows = fit, size = 0.0;
        Project(screen.Camera.U, screen.CenterX, screen.Camera.Width, left, right);
        Project(screen.Camera.V, screen.CenterY, screen.Camera.Height, bottom, top);

        // The w of a sliver may be stretched; see TriangleSetUp.
        var (one, stretch) = ((N)1.0, size * (N)(4 / screen.Scale));
        var leastW = w0 * (N)(1 - 1e-5) * (one - stretch);
        var mostW = N.Select(stretch < one, w1 * (N)(1 + 1e-5) * (one + stretch), double.PositiveInfinity);
        mostW.Store(most, 0);
        shows &= (mostW >= (N)(double)screen.LeastW) & (leastW <= (N)(double)screen.MostW);
        return (N.Bits(fit), N.Bits(shows));

        [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)] // in a method grown too large operators, silently, become calls
        void Project(Vector3 axis, double zero, double pixels, double[] first, double[] last)
        {
            N none = 0.0, scale = screen.Scale, middle = zero, margin = 2.0 * screen.Margin, end = pixels, guard = screen.Guard;
            var (least, most) = Range(axis, center, half);
            least = least * N.Select(least < none, inverse, inverseFar) * scale + middle - margin;
            most = most * N.Select(most < none, inverseFar, inverse) * scale + middle + margin;
            fit &= (least >= -guard) & (most <= end + guard);
            shows &= (least < end) & (most >= none);
            size += most - least;
            Keep(first, least, end - (N)1.0);
            Keep(last, most, end - (N)1.0);
        }
    }

    /// <summary>
    /// Which groups' middle triangles are seen the way around that has a tile's second place; see <see cref="TriangleSorter"/>. Only the order of
    /// work depends on it.
    /// </summary>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private uint Facings()
    {
        var (a, b, c) = (Middle(0), Middle(1), Middle(2));
        var (e, f, g) = (b - a, c - a, a - (Vector3<N>)screen.Camera.Position);
        var volume = (e.Y * f.Z - e.Z * f.Y) * g.X + (e.Z * f.X - e.X * f.Z) * g.Y + (e.X * f.Y - e.Y * f.X) * g.Z;
        return N.Bits(volume > (N)0.0);
    }

    /// <summary>The pixels before or at places; they are in the picture where the group shows.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Keep(double[] pixels, N place, N last) =>
        N.Select(place >= (N)0.0, N.Select(place < last, place, last), 0.0).Store(pixels, 0);

    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private void Place(int first, int end, int i, int side)
    {
        var (x0, x1, y0, y1) = (Pixel(left[i]), Pixel(right[i]), Pixel(bottom[i]), Pixel(top[i]));
        if (x0 < extent.Left) extent.Left = x0;
        if (x1 > extent.Right) extent.Right = x1;
        if (y0 < extent.Bottom) extent.Bottom = y0;
        if (y1 > extent.Top) extent.Top = y1;
        var group = new TriangleCluster(first, (float)most[i], Cells.Of(x0, x1, y0, y1));
        if (((x0 ^ x1) | (y0 ^ y1)) < Tile.MaxSide) Clusters.Add((PlaceOf(x0 / Tile.MaxSide, y0 / Tile.MaxSide, side), group));
        else if (Tiles(x0, x1) * Tiles(y0, y1) > ManyTiles) each.Add(first, end);
        else PlaceInTiles(group, x0, x1, y0, y1, side);
    }

    private void PlaceInTiles(TriangleCluster group, uint x0, uint x1, uint y0, uint y1, int side)
    {
        for (var y = y0 / Tile.MaxSide; y <= y1 / Tile.MaxSide; y++)
        {
            for (var x = x0 / Tile.MaxSide; x <= x1 / Tile.MaxSide; x++)
            {
                var (column, row) = (x * Tile.MaxSide, y * Tile.MaxSide);
                const uint Last = Tile.MaxSide - 1;
                var cells = Cells.Of(Math.Max(x0, column), Math.Min(x1, column + Last), Math.Max(y0, row), Math.Min(y1, row + Last));
                Clusters.Add((PlaceOf(x, y, side), group with { Cells = cells }));
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private int PlaceOf(uint tileX, uint tileY, int side) => 2 * ((int)tileY * tilesAcross + (int)tileX) + side;

    /// <summary>How many tiles pixels lie in.</summary>
    private static long Tiles(uint first, uint last) => last / Tile.MaxSide - first / Tile.MaxSide + 1L;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static uint Pixel(double place) => (uint)double.ConvertToIntegerNative<int>(place);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static (N Least, N Most) Range(Vector3 axis, Vector3<N> center, Vector3<N> half)
    {
        Vector3<N> along = axis, across = new Vector3(Math.Abs(axis.X), Math.Abs(axis.Y), Math.Abs(axis.Z));
        var (middle, spread) = (center * along, half * across);
        return (middle - spread, middle + spread);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private Vector3<N> Middle(int corner) => N.Gather(vertices, indices, new(middles), 0, corner);
}
