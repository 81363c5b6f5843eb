namespace RayCaster.Testing.Fuzzing;

/// <summary>What docs/limits.md promises: no reader takes more memory, all in all, than so many times its input.</summary>
internal static class MemoryLimit
{
    public const int BytesOfScene = 75, BytesOfMesh = 75, BytesOfPicture = 10, BytesOfPixel = 3, BytesOfPixelFromPipe = 9, BytesOfColumn = 64;

    public static long OfScene(long bytes) => (1L << 22) + BytesOfScene * bytes;

    public static long OfMesh(long bytes) => (1L << 22) + BytesOfMesh * bytes;

    /// <param name="bytes">The file's.</param>
    /// <param name="width">Pixels in a line.</param>
    /// <param name="height">Lines.</param>
    public static long OfPicture(long bytes, long width, long height) =>
        (1L << 22) + BytesOfPicture * bytes + BytesOfPixel * width * height + BytesOfColumn * width;

    /// <summary>Of a pipe, which may hold less than its header promises; a PNG is kept as it comes.</summary>
    /// <inheritdoc cref="OfPicture"/>
    public static long OfPipe(long bytes, long width, long height) =>
        OfPicture(bytes, width, height) + (BytesOfPixelFromPipe - BytesOfPixel) * width * height;
}
