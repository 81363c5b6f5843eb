namespace RayCaster.Engine;

/// <summary>What each pixel of a picture hits, and where: line 0 at the top.</summary>
/// <param name="width">Pixels in a line.</param>
/// <param name="height">Lines.</param>
public sealed class HitMap(int width, int height) : ISpanSink
{
    /// <summary>Pixels in a line.</summary>
    public int Width { get; } = width;

    /// <summary>Lines.</summary>
    public int Height { get; } = height;

    /// <summary>The ray parameters of the nearest hits, from left to right, then from top to bottom; +∞ for none.</summary>
    public double[] T { get; } = new double[checked(width * height)];

    /// <summary>The models hit there, by their places in the scene; −1 for none.</summary>
    public int[] Model { get; } = new int[checked(width * height)];

    /// <inheritdoc/>
    void ISpanSink.Take(RaySpan span)
    {
        for (var i = 0; i < span.Rows; i++)
        {
            var first = PlaceOf(span.Column, span.Row + i);
            span.T.Slice(i * span.Pitch, span.Width).CopyTo(T.AsSpan(first));
            span.CopyModels(i * span.Pitch, Model.AsSpan(first, span.Width));
        }
    }

    /// <inheritdoc/>
    void ISpanSink.TakeMiss(in Tile part)
    {
        for (var row = part.Row; row < part.EndRow; row++) T.AsSpan(PlaceOf(part.Column, row), part.Width).Fill(double.PositiveInfinity);
        FillModels(part, -1);
    }

    /// <inheritdoc/>
    bool ISpanSink.TryTake(CoveredPart covered)
    {
        if (covered.Shapes is not [var only] || covered.Part.Width < WidePacket.Count) return false;
        only.View.Hit(covered, T, PlaceOf(covered.Part.Column, covered.Part.Row), -Width);
        FillModels(covered.Part, only.Index);
        return true;
    }

    /// <inheritdoc/>
    bool ISpanSink.TryTake(in Tile tile, ModelView view, int index) =>
        view is ITileView alone && alone.Hit(tile, index, T, Model, PlaceOf(tile.Column, tile.Row), -Width);

    private void FillModels(in Tile part, int index)
    {
        for (var row = part.Row; row < part.EndRow; row++) Model.AsSpan(PlaceOf(part.Column, row), part.Width).Fill(index);
    }

    private int PlaceOf(int column, int row) => (Height - 1 - row) * Width + column;
}
