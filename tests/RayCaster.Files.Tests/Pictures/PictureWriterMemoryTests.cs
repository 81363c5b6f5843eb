namespace RayCaster.Files.Tests.Pictures;

/// <summary>Counts the allocations of all threads.</summary>
[Collection(Alone.Name)]
public class PictureWriterMemoryTests
{
    [Theory]
    [InlineData(PictureFormat.Png)]
    [InlineData(PictureFormat.Ppm)]
    [InlineData(PictureFormat.PpmText)]
    public void MemoryDoesNotGrowWithTheHeight(PictureFormat format)
    {
        var lines = new byte[64 * 3 * 1000];
        new Random(1).NextBytes(lines.AsSpan(lines.Length * 7 / 8));
        Write(format, lines, 1); // what is needed once
        var before = GC.GetTotalAllocatedBytes(precise: true);
        Write(format, lines, 100); // 19 MB
        Assert.InRange(GC.GetTotalAllocatedBytes(precise: true) - before, 0, 8_000_000);
    }

    private static void Write(PictureFormat format, byte[] lines, int times)
    {
        using var writer = PictureWriter.Create(format, Stream.Null, 1000, 64 * times);
        for (var i = 0; i < times; i++) writer.WriteRows(lines);
        writer.Finish();
    }
}
