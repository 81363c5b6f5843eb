namespace RayCaster.Engine;

/// <summary>What is known of a member of a batch before its formula is computed.</summary>
internal struct BatchItem
{
    public Sides Sides;

    /// <summary>No hit of it is nearer.</summary>
    public float Nearest;

    public int Kind, Index;

    /// <summary>Whether all of its hits certainly count.</summary>
    public bool IsClear;
}

/// <summary>The sides of a rectangle of pixels, stored so that the greater numbers of two rectangles are the sides of their intersection.</summary>
/// <param name="numbers">The first column, the first row, and the negated column and row after the last.</param>
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
internal readonly struct Sides(Vector128<int> numbers)
{
    private readonly Vector128<int> numbers = numbers;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Sides(int left, int bottom, int right, int top) : this(Vector128.Create(left, bottom, -right, -top)) { }

    public Sides(in PixelRect tile) : this(tile.Column, tile.Row, tile.EndColumn, tile.EndRow) { }

    public int Left => numbers[0];

    public int Bottom => numbers[1];

    public int Right => -numbers[2];

    public int Top => -numbers[3];

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Sides And(Sides other) => new(Vector128.Max(numbers, other.numbers));

    public bool HasPixels
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => ((numbers + Vector128.Shuffle(numbers, Vector128.Create(2, 3, 0, 1))).ExtractMostSignificantBits() & 3) == 3;
    }
}
