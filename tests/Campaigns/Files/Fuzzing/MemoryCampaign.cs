using System.IO.Compression;
using RayCaster.Testing.Fuzzing;
using static RayCaster.Files.Tests.Fuzzing.MemoryTests;

namespace RayCaster.Files.Tests.Fuzzing;

/// <summary>The inputs that take the most memory for their size, a megabyte of each; no reader takes more than docs/limits.md says.</summary>
public class MemoryCampaign
{
    [Theory]
    [MemberData(nameof(Scenes), MemberType = typeof(MemoryTests))]
    public void ASceneTakesNoMoreThanIsSaid(string shape) => Reading.OfScene(new("a.json", Filled(shape)));

    [Theory]
    [MemberData(nameof(Meshes), MemberType = typeof(MemoryTests))]
    public void AMeshTakesNoMoreThanIsSaid(string name, string shape) => Reading.OfMesh(new(name, Filled(shape)));

    [Theory]
    [MemberData(nameof(Pictures), MemberType = typeof(MemoryTests))]
    public void APictureTakesNoMoreThanIsSaid(string shape) => Reading.OfPicture(new("a.ppm", Filled(shape)));

    /// <summary>What is small in the file and large in memory: lines as long as they may be, in all kinds of pixels, and pictures of one bit a
    /// pixel.</summary>
    [Theory]
    [InlineData(1_000_000, 1, 16, 6, false)]
    [InlineData(1_000_000, 1, 8, 2, false)]
    [InlineData(1_000_000, 1, 1, 0, false)]
    [InlineData(1_000_000, 8, 16, 6, true)]
    [InlineData(1_000_000, 8, 1, 3, true)]
    [InlineData(1, 1_000_000, 8, 2, false)]
    [InlineData(8000, 8000, 1, 0, false)]
    public void ASmallFileOfALargePictureTakesNoMoreThanIsSaid(int width, int height, byte bits, byte color, bool interlaced)
    {
        var header = new PngHeader(width, height, bits, color, interlaced);
        var (file, data) = (new MemoryStream(), new MemoryStream());
        using (var zlib = new ZLibStream(data, CompressionLevel.Optimal, leaveOpen: true)) zlib.Write(new byte[(long)header.DataBytes]);
        file.Write(PngChunk.Signature);
        PngChunk.Write(file, "IHDR"u8, header.ToBytes());
        if (color == PngHeader.Palette) PngChunk.Write(file, "PLTE"u8, [0, 0, 0]);
        PngChunk.Write(file, "IDAT"u8, data.ToArray());
        PngChunk.Write(file, "IEND"u8, []);
        Promise.Within(MemoryLimit.OfPicture(file.Length, width, height), () => PictureFile.Read(new MemoryStream(file.ToArray())));
    }
}
