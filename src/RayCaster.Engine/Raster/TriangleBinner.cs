namespace RayCaster.Engine;

/// <summary>Finds the tiles of triangles, eight at a time; each thread has its own.</summary>
/// <param name="duplicates">The large triangles so far; null if duplicates do not matter.</param>
internal sealed class TriangleBinner(ScreenSpace screen, CornerSource corners, Duplicates? duplicates)
{
    /// <summary>A triangle in more tiles than this is stored once, and each tile looks for those that reach to it: a list of each tile would take
    /// more memory than the mesh.</summary>
    private const int ManyTiles = 4;

    private readonly int shift = ShiftOf(screen.Camera);

    public TileLists Lists { get; } = new(screen.Camera.Width);

    /// <summary>Triangles in many tiles; their cells are squares of the picture (<see cref="ShiftOf"/>).</summary>
    public PooledList<TriangleCluster> Large { get; } = new();

    /// <summary>Triangles with a corner that is not fit for floats.</summary>
    public List<int> Unfit { get; } = [];

    /// <summary>A power of two, the side of squares of which a picture has at most 256 along each side; none is smaller than a tile.</summary>
    public static int ShiftOf(Camera camera)
    {
        var shift = 6;
        while (Math.Max(camera.Width, camera.Height) >> shift > byte.MaxValue) shift++;
        return shift;
    }

    /// <summary>Sorts triangles; drops those that certainly cover no sample.</summary>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    public void Add(int first, int end)
    {
        var (zero, one) = (Vector256<float>.Zero, Vector256<float>.One);
        var margin = Vector256.Create(screen.Margin);
        var (lastColumn, lastRow) = (Vector256.Create(screen.Camera.Width - 1f), Vector256.Create(screen.Camera.Height - 1f));
        var spread = Vector256.Create((float)(4 / screen.Scale));
        var (minInverseDepth, maxInverseDepth) = (Vector256.Create(screen.MinInverseDepth), Vector256.Create(screen.MaxInverseDepth));
        Span<int> ids = stackalloc int[8];
        Span<int> box = stackalloc int[32];
        Span<float> inverseDepths = stackalloc float[8];
        for (; first < end; first += 8)
        {
            for (var i = 0; i < 8; i++) ids[i] = Math.Min(first + i, end - 1);
            corners.Project(ids, out var t);
            var (left, right) = (Lanes.MinOrLast(t.A.X, t.B.X, t.C.X), Lanes.MaxOrLast(t.A.X, t.B.X, t.C.X));
            var (bottom, top) = (Lanes.MinOrLast(t.A.Y, t.B.Y, t.C.Y), Lanes.MaxOrLast(t.A.Y, t.B.Y, t.C.Y));
            var size = right - left + (top - bottom);

            // The samples in the triangle's box. A picture's columns and rows are exact in floats.
            var column0 = Lanes.MaxOrLast(Vector256.Ceiling(left - margin), zero);
            var column1 = Lanes.MinOrLast(Vector256.Floor(right + margin), lastColumn);
            var row0 = Lanes.MaxOrLast(Vector256.Ceiling(bottom - margin), zero);
            var row1 = Lanes.MinOrLast(Vector256.Floor(top + margin), lastRow);
            var fit = screen.IsFit(t.A) & screen.IsFit(t.B) & screen.IsFit(t.C);
            var shows = Vector256.LessThanOrEqual(column0, column1) & Vector256.LessThanOrEqual(row0, row1);

            // The range of inverse depth that counts; see TriangleSetUp on the stretch of the corners' inverse depth.
            var stretch = size * spread;
            var (most, least) = (t.MaxInverseDepth, t.MinInverseDepth);
            shows &= Vector256.GreaterThanOrEqual(most * (one + stretch), minInverseDepth) | Vector256.GreaterThan(stretch, one);
            shows &= Vector256.LessThanOrEqual(least * (one - stretch), maxInverseDepth);

            shows &= fit;
            var inRange = end - first >= 8 ? 0xFFu : (1u << (end - first)) - 1;
            var unfit = ~fit.ExtractMostSignificantBits() & inRange;
            for (; unfit != 0; unfit &= unfit - 1)
            {
                var i = first + BitOperations.TrailingZeroCount(unfit);
                if (duplicates is null || !duplicates.HasEarlier(i)) Unfit.Add(i);
            }
            var bits = shows.ExtractMostSignificantBits() & inRange;
            if (bits == 0) continue;

            Vector256.ConvertToInt32(column0).CopyTo(box);
            Vector256.ConvertToInt32(column1).CopyTo(box[8..]);
            Vector256.ConvertToInt32(row0).CopyTo(box[16..]);
            Vector256.ConvertToInt32(row1).CopyTo(box[24..]);
            (TriangleSetUp.StretchedInverseDepth(most, size, screen) * Vector256.Create(1 + 1e-5f)).CopyTo(inverseDepths);
            for (; bits != 0; bits &= bits - 1)
            {
                var i = BitOperations.TrailingZeroCount(bits);
                Bin(first + i, inverseDepths[i], (uint)box[i], (uint)box[i + 8], (uint)box[i + 16], (uint)box[i + 24]);
            }
        }
    }

    private void Bin(int triangle, float maxInverseDepth, uint left, uint right, uint bottom, uint top)
    {
        var tiles = TileLists.TilesOf(left, right, bottom, top);
        if (tiles > 1 && duplicates is not null && duplicates.HasEarlier(triangle)) return;
        if (tiles <= ManyTiles) Lists.Add(new(triangle, 1), maxInverseDepth, left, right, bottom, top);
        else Large.Add(new(new(triangle, 1), maxInverseDepth,
            new((byte)(left >> shift), (byte)(right >> shift), (byte)(bottom >> shift), (byte)(top >> shift))));
    }
}
