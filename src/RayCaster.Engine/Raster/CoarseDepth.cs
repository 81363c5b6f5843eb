namespace RayCaster.Engine;

/// <summary>A coarse depth buffer: for each cell of 8 × 8 pixels the least inverse depth that their hits certainly have. What lies behind is
/// hidden. The field calls it hierarchical Z (Hi-Z). What is hidden before it is rasterized is known as in masked occlusion culling (Hasselgren,
/// Andersson, Akenine-Möller, "Masked Software Occlusion Culling", 2016).</summary>
/// <remarks>No inverse depth that a hit certainly has is NaN, so native minima are the same on all processors.</remarks>
internal sealed class CoarseDepth
{
    public const int CellSide = 8;

    private const int Across = Tile.MaxSide / CellSide;

    private readonly float[] least = new float[Across * Across];

    public void Clear() => least.AsSpan().Clear();

    /// <summary>Finds the least inverse depth of each cell. Rows are <see cref="Tile.MaxSide"/> numbers long.</summary>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    public void Update(float[] occluderInverseDepth)
    {
        for (var cell = 0; cell < least.Length; cell++)
        {
            var first = cell / Across * CellSide * Tile.MaxSide + cell % Across * CellSide;
            var inverseDepth = occluderInverseDepth.Load256(first);
            for (var row = 1; row < CellSide; row++)
                inverseDepth = Vector256.MinNative(inverseDepth, occluderInverseDepth.Load256(first + row * Tile.MaxSide));
            var half = Vector128.MinNative(inverseDepth.GetLower(), inverseDepth.GetUpper());
            half = Vector128.MinNative(half, Vector128.Shuffle(half, Vector128.Create(2, 3, 0, 1)));
            least[cell] = Math.Min(half[0], half[1]);
        }
    }

    /// <summary>Whether each pixel of some cells certainly has a hit with a greater inverse depth.</summary>
    /// <param name="cells">Cells of a whole tile.</param>
    /// <param name="firstRow">The first row of that tile whose pixels are known.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Hides(Cells cells, int firstRow, float inverseDepth)
    {
        var row = Vector256.Create(float.PositiveInfinity);
        var top = Math.Min(Across - 1, (cells.Top * CellSide + CellSide - 1 - firstRow) >> 3);
        for (var y = Math.Max(0, cells.Bottom * CellSide - firstRow) >> 3; y <= top; y++)
            row = Vector256.MinNative(row, least.Load256(y * Across));
        var hidden = Vector256.GreaterThan(row, Vector256.Create(inverseDepth)).ExtractMostSignificantBits();
        var columns = (2u << cells.Right) - (1u << cells.Left);
        return (hidden & columns) == columns;
    }

    /// <summary>Each pixel certainly has a hit of at least this inverse depth; 0 if that is not certain.</summary>
    public float Least
    {
        get
        {
            var inverseDepth = float.PositiveInfinity;
            foreach (var cell in least) inverseDepth = Math.Min(inverseDepth, cell);
            return inverseDepth;
        }
    }
}

/// <summary>A rectangle of cells of a tile.</summary>
internal readonly record struct Cells(byte Left, byte Right, byte Bottom, byte Top)
{
    public static Cells All => Of(0, Tile.MaxSide - 1, 0, Tile.MaxSide - 1);

    /// <summary>The cells of pixels, by their columns and rows in the picture.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Cells Of(uint left, uint right, uint bottom, uint top) => new(CellOf(left), CellOf(right), CellOf(bottom), CellOf(top));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static byte CellOf(uint pixel) => (byte)(pixel % Tile.MaxSide / CoarseDepth.CellSide);
}
