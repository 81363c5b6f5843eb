namespace RayCaster.Engine;

/// <summary>What each pixel of a picture hits, and where: line 0 at the top.</summary>
public sealed class HitMap(int width, int height)
{
    /// <summary>Pixels in a line.</summary>
    public int Width { get; } = width;

    /// <summary>Lines.</summary>
    public int Height { get; } = height;

    /// <summary>The ray parameters of the nearest hits, from left to right, then from top to bottom; +∞ for none.</summary>
    public double[] T { get; } = new double[checked(width * height)];

    /// <summary>The models hit there, by their places in the scene; −1 for none.</summary>
    public int[] Model { get; } = new int[checked(width * height)];

    /// <summary>The hit of a pixel, by its index in reading order.</summary>
    public Hit this[int pixel]
    {
        get => new(T[pixel], Model[pixel]);
        internal set => (T[pixel], Model[pixel]) = value;
    }

    /// <summary>The hit of a pixel.</summary>
    /// <param name="line">Counted from the top.</param>
    public Hit this[int column, int line] => this[line * Width + column];
}
