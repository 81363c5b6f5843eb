namespace RayCaster;

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
        var first = (Height - 1 - span.Row) * Width + span.Column;
        span.T[..span.Length].CopyTo(T.AsSpan(first));
        for (var i = 0; i < span.Length; i++) Model[first + i] = span.ModelAt(i);
    }
}
