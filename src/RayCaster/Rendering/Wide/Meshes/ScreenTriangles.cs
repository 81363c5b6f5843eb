using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace RayCaster;

/// <summary>Projected triangles, sorted into the tiles of the picture in which they may cover a sample.</summary>
/// <param name="screen">The camera.</param>
/// <param name="points">x, y, w and whether it is unfit, of each vertex.</param>
/// <param name="indices">Three vertices for each triangle.</param>
/// <param name="owners">The mesh's triangle that each belongs to; null where they are the same.</param>
internal sealed class ScreenTriangles(ScreenSpace screen, Vector128<float>[] points, int[] indices, int[]? owners)
{
    /// <summary>A triangle in more tiles than this is looked at in every tile, so that a million large ones do not need a place in each.</summary>
    private const int ManyTiles = 64;

    private readonly int tilesAcross = Frame.TilesOf(screen.Camera.Width);
    private readonly int tileCount = Frame.TilesOf(screen.Camera.Width) * Frame.TilesOf(screen.Camera.Height);
    private readonly GrowingArray<int> places = new(), listed = new(), large = new();
    private int[] starts = [], sorted = [];
    private (int Left, int Right, int Bottom, int Top) extent = (int.MaxValue, -1, int.MaxValue, -1);

    public Vector128<float>[] Points => points;

    public int[] Indices => indices;

    /// <summary>Where samples may be covered.</summary>
    public (int Left, int Right, int Bottom, int Top) Extent => extent;

    /// <summary>Triangles with corners that are not fit for floats; they are not sorted.</summary>
    public GrowingArray<int> Unfit { get; } = new();

    /// <summary>Those that may show in any tile.</summary>
    public ReadOnlySpan<int> Large => large.Items;

    /// <summary>Those of a tile that are seen with their corners one way (0) or the other way (1) around.</summary>
    public ReadOnlySpan<int> Of(in Tile tile, int side)
    {
        var place = 2 * (tile.Row / Tile.MaxSide * tilesAcross + tile.Column / Tile.MaxSide) + side;
        return sorted.AsSpan(starts[place], starts[place + 1] - starts[place]);
    }

    /// <summary>The mesh's triangle.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int OwnerOf(int triangle) => owners is null ? triangle : owners[triangle];

    /// <summary>Finds the tiles of all triangles. Those that surely cover no sample are dropped: of ten million in one picture nearly all.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public void Sort()
    {
        var count = indices.Length / 3;
        var (width, height) = (screen.Camera.Width, screen.Camera.Height);
        var margin = Vector256.Create(screen.Margin);
        var zero = Vector256<float>.Zero;
        var one = Vector256.Create(1f);
        var (lastColumn, lastRow) = (Vector256.Create(width - 1f), Vector256.Create(height - 1f));
        var spread = Vector256.Create((float)(4 / screen.Scale));
        var (leastW, mostW) = (Vector256.Create(screen.LeastW), Vector256.Create(screen.MostW));
        Span<int> ids = stackalloc int[8];
        Span<int> box = stackalloc int[32];
        for (var first = 0; first < count; first += 8)
        {
            for (var i = 0; i < 8; i++) ids[i] = Math.Min(first + i, count - 1);
            var t = new EightTriangles(points, indices, ids);
            var (left, right) = (Least(t.AX, t.BX, t.CX), Most(t.AX, t.BX, t.CX));
            var (bottom, top) = (Least(t.AY, t.BY, t.CY), Most(t.AY, t.BY, t.CY));
            var size = right - left + (top - bottom);

            // The samples within the box around the triangle. Columns and rows of a picture are exact in floats.
            var column0 = Vector256.MaxNative(Vector256.Ceiling(left - margin), zero);
            var column1 = Vector256.MinNative(Vector256.Floor(right + margin), lastColumn);
            var row0 = Vector256.MaxNative(Vector256.Ceiling(bottom - margin), zero);
            var row1 = Vector256.MinNative(Vector256.Floor(top + margin), lastRow);
            var unfit = Vector256.GreaterThan(t.Unfit, zero);
            var shows = Vector256.LessThanOrEqual(column0, column1) & Vector256.LessThanOrEqual(row0, row1);

            // The range of w that counts; see SetUp on the stretch of the corners' w.
            var stretch = size * spread;
            shows &= Vector256.GreaterThanOrEqual(Most(t.AW, t.BW, t.CW) * (one + stretch), leastW) | Vector256.GreaterThan(stretch, one);
            shows &= Vector256.LessThanOrEqual(Least(t.AW, t.BW, t.CW) * (one - stretch), mostW);

            // Where the box holds one sample only, the sides tell whether it is beside the triangle. (The others are looked at in their tiles.)
            var (ax, bx, cx) = (t.AX - column0, t.BX - column0, t.CX - column0);
            var (ay, by, cy) = (t.AY - row0, t.BY - row0, t.CY - row0);
            var (u, v, w) = (bx * cy - by * cx, cx * ay - cy * ax, ax * by - ay * bx);
            var slack = size * (Vector256.Create(6 * screen.Margin) + size * Vector256.Create(Roundings));
            var (least, most) = (Least(u, v, w), Most(u, v, w));
            var beside = Vector256.LessThan(least, -slack) & Vector256.GreaterThan(most, slack);
            shows &= ~(beside & Vector256.Equals(column0, column1) & Vector256.Equals(row0, row1)) & ~unfit;

            var inRange = count - first >= 8 ? 0xFFu : (1u << (count - first)) - 1;
            var unfitBits = unfit.ExtractMostSignificantBits() & inRange;
            for (; unfitBits != 0; unfitBits &= unfitBits - 1) Unfit.Add(first + System.Numerics.BitOperations.TrailingZeroCount(unfitBits));
            var bits = shows.ExtractMostSignificantBits() & inRange;
            if (bits == 0) continue;

            var turned = Vector256.LessThan(u + v + w, zero).ExtractMostSignificantBits();
            Vector256.ConvertToInt32(column0).CopyTo(box);
            Vector256.ConvertToInt32(column1).CopyTo(box[8..]);
            Vector256.ConvertToInt32(row0).CopyTo(box[16..]);
            Vector256.ConvertToInt32(row1).CopyTo(box[24..]);
            for (; bits != 0; bits &= bits - 1)
            {
                var i = System.Numerics.BitOperations.TrailingZeroCount(bits);
                List(first + i, (int)(turned >> i) & 1, box[i], box[i + 8], box[i + 16], box[i + 24]);
            }
        }
        SortByPlace();
    }

    /// <summary>What a float computation with numbers of a size of up to 1 and some roundings is off by at most.</summary>
    internal const float Roundings = 1f / (1 << 20);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<float> Least(Vector256<float> a, Vector256<float> b, Vector256<float> c) =>
        Vector256.MinNative(a, Vector256.MinNative(b, c));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<float> Most(Vector256<float> a, Vector256<float> b, Vector256<float> c) =>
        Vector256.MaxNative(a, Vector256.MaxNative(b, c));

    private void List(int triangle, int side, int left, int right, int bottom, int top)
    {
        extent = (Math.Min(extent.Left, left), Math.Max(extent.Right, right), Math.Min(extent.Bottom, bottom), Math.Max(extent.Top, top));
        var (x0, x1, y0, y1) = (left / Tile.MaxSide, right / Tile.MaxSide, bottom / Tile.MaxSide, top / Tile.MaxSide);
        if ((long)(x1 - x0 + 1) * (y1 - y0 + 1) > ManyTiles)
        {
            large.Add(triangle);
            return;
        }
        for (var y = y0; y <= y1; y++)
        {
            for (var x = x0; x <= x1; x++)
            {
                places.Add(2 * (y * tilesAcross + x) + side);
                listed.Add(triangle);
            }
        }
    }

    /// <summary>A counting sort, which keeps the order of a place's triangles.</summary>
    private void SortByPlace()
    {
        starts = new int[2 * tileCount + 1];
        var keys = places.Items;
        var values = listed.Items;
        foreach (var place in keys) starts[place + 1]++;
        for (var i = 1; i < starts.Length; i++) starts[i] += starts[i - 1];
        sorted = new int[keys.Length];
        for (var i = 0; i < keys.Length; i++) sorted[starts[keys[i]]++] = values[i];
        for (var i = starts.Length - 1; i > 0; i--) starts[i] = starts[i - 1];
        starts[0] = 0;
        places.Clear();
        listed.Clear();
    }
}
