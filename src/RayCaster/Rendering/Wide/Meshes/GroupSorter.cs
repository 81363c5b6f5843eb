using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace RayCaster;

/// <summary>
/// One thread's tool: finds the tiles of a mesh's triangles, by the box around sixteen of them that follow one another. Where that box says
/// little, each triangle is looked at.
/// </summary>
internal sealed class GroupSorter(ScreenSpace screen, Vector3[] vertices, int[] indices, TriangleSorter each)
{
    /// <summary>The triangles of a group in more tiles than this are sorted one by one: they lie far from each other, or are large.</summary>
    private const int ManyTiles = 6;

    private readonly int tilesAcross = Frame.TilesOf(screen.Camera.Width);
    private readonly Vector3[] lows = new Vector3[Packet.Count], highs = new Vector3[Packet.Count];
    private readonly int[] left = new int[Packet.Count], right = new int[Packet.Count], bottom = new int[Packet.Count], top = new int[Packet.Count];
    private readonly double[] most = new double[Packet.Count];
    private (int Left, int Right, int Bottom, int Top) extent = (int.MaxValue, -1, int.MaxValue, -1);

    /// <summary>Groups by tile and side.</summary>
    public GrowingArray<(int Place, Group Group)> Groups { get; } = new();

    /// <summary>Where samples may be covered.</summary>
    public (int Left, int Right, int Bottom, int Top) Extent => extent;

    /// <summary>Takes triangles.</summary>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    public void Add(int first, int end)
    {
        for (; first < end; first += Packet.Count * Group.Length)
        {
            for (var i = 0; i < Packet.Count; i++) Bound(first + i * Group.Length, Math.Min(first + (i + 1) * Group.Length, end), i);
            var (fit, shows) = Project();
            for (var i = 0; i < Packet.Count && first + i * Group.Length < end; i++)
            {
                var (begin, bit) = (first + i * Group.Length, 1u << i);
                if ((fit & bit) == 0) each.Add(begin, Math.Min(begin + Group.Length, end));
                else if ((shows & bit) != 0) Place(begin, Math.Min(begin + Group.Length, end), i);
            }
        }
    }

    /// <summary>The box around triangles; a corner that is no number does not count, for it is part of no hit.</summary>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private void Bound(int first, int end, int group)
    {
        var (low, high) = (Vector256.Create(double.PositiveInfinity), Vector256.Create(double.NegativeInfinity));
        for (var i = 3 * first; i < 3 * end; i++)
        {
            var corner = Lanes.NumberAndPoint(ref vertices[indices[i]]); // here each index is checked, once for all
            low = Vector256.MinNative(corner, low);
            high = Vector256.MaxNative(corner, high);
        }
        lows[group] = new(low[1], low[2], low[3]);
        highs[group] = new(high[1], high[2], high[3]);
    }

    /// <summary>The rectangles on the screen and the ranges of w of four boxes.</summary>
    /// <remarks>
    /// Rounding moves a rectangle's sides by some 2⁻⁵³ of (distance + size) / least depth, in units of the scale; the size is held below the least depth,
    /// and so that is less than <see cref="ScreenSpace.DoubleMargin"/>, by which the formula, too, may see a corner elsewhere.
    /// </remarks>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private (uint Fit, uint Shows) Project()
    {
        Vector3<Packet> eye = screen.Camera.Position;
        var (low, high) = (Load(lows) - eye, Load(highs) - eye);
        var (center, half) = ((Packet)0.5 * (low + high), (Packet)0.5 * (high - low));
        var (nearest, farthest) = Range(-screen.Camera.W, center, half);
        var (inverse, inverseFar) = ((Packet)1 / nearest, (Packet)1 / farthest);
        Packet margin = 2 * screen.Margin, scale = screen.Scale;

        var (x0, x1) = Range(screen.Camera.U, center, half);
        x0 = x0 * Packet.Select(x0 < 0, inverse, inverseFar) * scale + screen.CenterX - margin;
        x1 = x1 * Packet.Select(x1 < 0, inverseFar, inverse) * scale + screen.CenterX + margin;
        var (y0, y1) = Range(screen.Camera.V, center, half);
        y0 = y0 * Packet.Select(y0 < 0, inverse, inverseFar) * scale + screen.CenterY - margin;
        y1 = y1 * Packet.Select(y1 < 0, inverseFar, inverse) * scale + screen.CenterY + margin;
        var (w0, w1) = ((Packet)screen.Unit * inverseFar, (Packet)screen.Unit * inverse);

        // The w of a sliver may be stretched; see TriangleSetUp.
        var stretch = (x1 - x0 + (y1 - y0)) * (4 / screen.Scale);
        var leastW = w0 * (1 - 1e-5) * ((Packet)1 - stretch);
        var mostW = Packet.Select(stretch < 1, w1 * (1 + 1e-5) * ((Packet)1 + stretch), double.PositiveInfinity);
        mostW.Store(most, 0);

        double guard = screen.Guard, width = screen.Camera.Width, height = screen.Camera.Height;
        var fit = (nearest > half.X + half.Y + half.Z) & (w0 > 1e-29) & (w1 < 1e29)
            & (x0 >= -guard) & (x1 <= width + guard) & (y0 >= -guard) & (y1 <= height + guard);
        var shows = (x0 < width) & (x1 >= 0) & (y0 < height) & (y1 >= 0) & (mostW >= screen.LeastW) & (leastW <= screen.MostW);
        Keep(left, x0, width - 1);
        Keep(right, x1, width - 1);
        Keep(bottom, y0, height - 1);
        Keep(top, y1, height - 1);
        return (fit.Lanes.ExtractMostSignificantBits(), shows.Lanes.ExtractMostSignificantBits());
    }

    /// <summary>The pixels before or at places; they are in the picture where the group shows.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Keep(int[] pixels, Packet place, double last) =>
        Packet.Select(place >= 0, Packet.Select(place < last, place, last), 0).ToInts().StoreUnsafe(ref pixels[0]);

    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private void Place(int first, int end, int i)
    {
        var (x0, x1, y0, y1) = (left[i], right[i], bottom[i], top[i]);
        var (tileX0, tileX1, tileY0, tileY1) = (x0 / Tile.MaxSide, x1 / Tile.MaxSide, y0 / Tile.MaxSide, y1 / Tile.MaxSide);
        if ((tileX1 - tileX0 + 1) * (tileY1 - tileY0 + 1) > ManyTiles)
        {
            each.Add(first, end);
            return;
        }

        if (x0 < extent.Left) extent.Left = x0;
        if (x1 > extent.Right) extent.Right = x1;
        if (y0 < extent.Bottom) extent.Bottom = y0;
        if (y1 > extent.Top) extent.Top = y1;
        var (side, mostW) = (SideOf((first + end) / 2), (float)most[i]);
        for (var y = tileY0; y <= tileY1; y++)
            for (var x = tileX0; x <= tileX1; x++)
                Groups.Add((2 * (y * tilesAcross + x) + side, new(first, mostW,
                    new(Cell(x0 - x * Tile.MaxSide), Cell(x1 - x * Tile.MaxSide), Cell(y0 - y * Tile.MaxSide), Cell(y1 - y * Tile.MaxSide)))));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static byte Cell(int pixel) => (byte)((uint)Math.Max(0, Math.Min(pixel, Tile.MaxSide - 1)) / CoarseDepth.CellSide);

    /// <summary>Which way around a triangle's corners are seen. Only the order of work depends on it.</summary>
    private int SideOf(int triangle)
    {
        var (a, b, c) = (vertices[indices[3 * triangle]], vertices[indices[3 * triangle + 1]], vertices[indices[3 * triangle + 2]]);
        return (b - a) % (c - a) * (a - screen.Camera.Position) < 0 ? 0 : 1;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static (Packet Least, Packet Most) Range(Vector3 axis, Vector3<Packet> center, Vector3<Packet> half)
    {
        Vector3<Packet> along = axis, across = new Vector3(Math.Abs(axis.X), Math.Abs(axis.Y), Math.Abs(axis.Z));
        var (middle, spread) = (center * along, half * across);
        return (middle - spread, middle + spread);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector3<Packet> Load(Vector3[] points) => Lanes.Transpose(
        Lanes.NumberAndPoint(ref points[0]), Lanes.NumberAndPoint(ref points[1]), Lanes.NumberAndPoint(ref points[2]), Lanes.NumberAndPoint(ref points[3]));
}
