namespace RayCaster.Testing.Fuzzing;

/// <summary>What docs/limits.md promises: no reader takes more memory, all in all, than so many times its input.</summary>
internal static class MemoryLimit
{
    public const int BytesOfScene = 75, BytesOfMesh = 75, BytesOfPicture = 20;

    public static long OfScene(long bytes) => (1L << 22) + BytesOfScene * bytes;

    public static long OfMesh(long bytes) => (1L << 22) + BytesOfMesh * bytes;

    /// <param name="bytes">The file's.</param>
    /// <param name="pixels">The picture's.</param>
    public static long OfPicture(long bytes, long pixels) => (1L << 22) + BytesOfPicture * bytes + 4 * pixels;
}
