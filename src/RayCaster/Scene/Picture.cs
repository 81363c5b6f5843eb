namespace RayCaster;

/// <summary>A picture in memory: 8 bits each of red, green and blue, line 0 at the top.</summary>
public sealed class Picture
{
    /// <param name="width">Pixels in a line, at least 1.</param>
    /// <param name="height">Lines, at least 1.</param>
    /// <exception cref="ArgumentOutOfRangeException">A side is less than 1.</exception>
    /// <exception cref="OverflowException">The picture would have more than 2³¹ bytes.</exception>
    public Picture(int width, int height)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(width, 1);
        ArgumentOutOfRangeException.ThrowIfLessThan(height, 1);
        (Width, Height, Rgb) = (width, height, new byte[checked(width * height * 3)]);
    }

    /// <summary>A picture over bytes that exist already.</summary>
    /// <param name="rgb">Its width · height · 3 bytes; they are not copied.</param>
    /// <exception cref="ArgumentException">The number of bytes does not fit the size.</exception>
    public Picture(int width, int height, byte[] rgb)
    {
        if (width < 1 || height < 1 || rgb.LongLength != 3L * width * height)
            throw new ArgumentException($"{rgb.LongLength} bytes for a picture of {width} x {height}", nameof(rgb));
        (Width, Height, Rgb) = (width, height, rgb);
    }

    /// <summary>Pixels in a line.</summary>
    public int Width { get; }

    /// <summary>Lines.</summary>
    public int Height { get; }

    /// <summary>Width · Height · 3 bytes: red, green, blue of each pixel; from left to right, then from top to bottom.</summary>
    public byte[] Rgb { get; }

    /// <summary>A pixel's three bytes.</summary>
    /// <param name="x">The column, from the left.</param>
    /// <param name="y">The line, from the top.</param>
    /// <exception cref="ArgumentOutOfRangeException">The picture has no such pixel.</exception>
    public (byte R, byte G, byte B) this[int x, int y]
    {
        get
        {
            var i = IndexOf(x, y);
            return (Rgb[i], Rgb[i + 1], Rgb[i + 2]);
        }
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        set
        {
            var i = IndexOf(x, y);
            (Rgb[i], Rgb[i + 1], Rgb[i + 2]) = value;
        }
    }

    private int IndexOf(int x, int y)
    {
        ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual((uint)x, (uint)Width, nameof(x));
        ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual((uint)y, (uint)Height, nameof(y));
        return (y * Width + x) * 3;
    }
}
