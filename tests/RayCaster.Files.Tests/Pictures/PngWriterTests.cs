using System.IO.Compression;
using RayCaster.Testing.Fuzzing;
using static RayCaster.Files.Tests.Pictures.PictureWriterTests;

namespace RayCaster.Files.Tests.Pictures;

public class PngWriterTests
{
    /// <summary>Some 5 MB, of which half does not compress: a picture of many chunks.</summary>
    private const int Width = 8_000, Height = 200;

    private static readonly Picture noise = Noise(Width, Height);
    private static readonly byte[] encoded = Encode(PictureFormat.Png, noise, Height);

    [Fact]
    public void APictureOfManyChunksIsReadBack() => Assert.Equal(noise.Rgb, PictureFile.Read(new MemoryStream(encoded)).Rgb);

    [Theory]
    [InlineData(400_000, 5)] // a line is more than a chunk
    [InlineData(8_000, 290)]
    public void TheDataAreOneZlibStream(int width, int height)
    {
        var picture = Noise(width, height);
        var chunks = Chunks(picture, height).Where(chunk => chunk.Type == "IDAT").Select(chunk => chunk.Data).ToArray();
        Assert.True(chunks.Length > 2);
        var data = chunks.Aggregate((one, next) => [.. one, .. next]);

        var lines = new MemoryStream();
        using (var decompressor = new ZLibStream(new MemoryStream(data), CompressionMode.Decompress)) decompressor.CopyTo(lines);
        Assert.Equal((1L + 3 * width) * height, lines.Length);
    }

    [Fact]
    public void AChunkIsAMegabyteAtMostAndALine()
    {
        var picture = Noise(Width, Height);
        new Random(1).NextBytes(picture.Rgb); // cannot be compressed
        Assert.All(Chunks(picture, Height), chunk => Assert.InRange(chunk.Data.Length, 0, (1 << 20) + (1 << 17)));
    }

    [Fact]
    public void AnErrorOfTheOutputMeetsTheOneWhoWrites()
    {
        var lines = noise.Rgb;
        var writer = PictureWriter.Create(PictureFormat.Png, new FullStream(room: 1 << 19), Width, Height * 1000);
        Assert.Throws<IOException>(() =>
        {
            for (var i = 0; i < 1000; i++) writer.WriteRows(lines);
        });
        writer.Dispose();
    }

    private static List<(string Type, byte[] Data)> Chunks(Picture picture, int height) =>
        PngMutation.Chunks(Encode(PictureFormat.Png, picture, height));

    /// <summary>An output that fails when it is full.</summary>
    private sealed class FullStream(int room) : MemoryStream
    {
        public override void Write(ReadOnlySpan<byte> buffer)
        {
            if (Length + buffer.Length > room) throw new IOException("full");
            base.Write(buffer);
        }
    }
}
