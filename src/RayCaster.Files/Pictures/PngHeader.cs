namespace RayCaster.Files;

/// <summary>A PNG's first chunk, IHDR, which describes its pixels.</summary>
internal readonly record struct PngHeader(int Width, int Height, int BitDepth, int ColorType, bool Interlaced)
{
    public const int Bytes = 13;

    public const int Rgb = 2;

    /// <summary>The colour type whose samples are places in the palette.</summary>
    public const int Palette = 3;

    /// <summary>The samples of a pixel. Colour type 0 is grey, 4 grey and alpha, 6 red, green, blue and alpha.</summary>
    public int Channels => ColorType switch { 0 or Palette => 1, 4 => 2, Rgb => 3, _ => 4 };

    public int BitsPerPixel => Channels * BitDepth;

    /// <summary>
    /// The reduced pictures that the file holds one after another: one picture of all pixels, or the seven of Adam7, which take pixels from
    /// finer and finer grids. The number of its filter stands before each line.
    /// </summary>
    public PngPass[] Passes
    {
        get
        {
            var (width, height) = (Width, Height);
            PngPass[] grids = Interlaced
                ? [new(0, 0, 8, 8), new(4, 0, 8, 8), new(0, 4, 4, 8), new(2, 0, 4, 4), new(0, 2, 2, 4), new(1, 0, 2, 2), new(0, 1, 1, 2)]
                : [new(0, 0, 1, 1)];
            return Array.FindAll(grids, grid => grid.X < width && grid.Y < height); // a small picture has no pixel in some
        }
    }

    /// <summary>The length of the file's data after decompression.</summary>
    public Int128 DataBytes
    {
        get
        {
            Int128 sum = 0;
            foreach (var pass in Passes) sum += (Int128)(1 + LineBytes(pass.Columns(Width))) * pass.Lines(Height);
            return sum;
        }
    }

    /// <summary>The bytes of a line, without the number of its filter; some bits of the last byte may mean nothing.</summary>
    public long LineBytes(int columns) => ((long)columns * BitsPerPixel + 7) / 8;

    public static PngHeader Read(ReadOnlySpan<byte> data, long maxBytes)
    {
        long width = BinaryPrimitives.ReadUInt32BigEndian(data), height = BinaryPrimitives.ReadUInt32BigEndian(data[4..]);
        PictureFile.ThrowIfTooLarge(width, height, maxBytes);
        if (width > Camera.MaxSide) // two lines of up to 8 bytes a pixel are in memory, whatever the file's size
            throw new ProblemException($"its lines have {width:N0} pixels, the limit is {Camera.MaxSide:N0}");
        if (height > int.MaxValue) // which PNG does not allow
            throw new ProblemException($"it has {height:N0} lines, the limit is {int.MaxValue:N0}");
        var header = new PngHeader((int)width, (int)height, data[8], data[9], data[12] == 1);
        var allowed = header.ColorType switch
        {
            0 => header.BitDepth is 1 or 2 or 4 or 8 or 16,
            Palette => header.BitDepth is 1 or 2 or 4 or 8,
            Rgb or 4 or 6 => header.BitDepth is 8 or 16,
            _ => throw new ProblemException($"its colour type is {data[9]}, but must be 0, 2, 3, 4 or 6"),
        };
        if (!allowed) throw new ProblemException($"its bit depth is {data[8]}, which colour type {data[9]} does not allow");
        if (data[10] != 0) throw new ProblemException($"its compression method is {data[10]}, but must be 0");
        if (data[11] != 0) throw new ProblemException($"its filter method is {data[11]}, but must be 0");
        if (data[12] > 1) throw new ProblemException($"its interlace method is {data[12]}, but must be 0 or 1");
        return header;
    }
}

/// <summary>A grid of pixels: from (X, Y) on, every <paramref name="StepX"/>th pixel of every <paramref name="StepY"/>th line.</summary>
internal readonly record struct PngPass(int X, int Y, int StepX, int StepY)
{
    public int Columns(int width) => (width - X - 1) / StepX + 1;

    public int Lines(int height) => (height - Y - 1) / StepY + 1;
}
