using static RayCaster.Files.Tests.Pictures.TestPng;

namespace RayCaster.Files.Tests.Pictures;

/// <summary>The alpha of PNG files.</summary>
public class AlphaTests
{
    public static TheoryData<byte[], byte[]?> Files => new()
    {
        { Png(Header(2, 1, 8, 6), Data(0, 1, 2, 3, 0, 4, 5, 6, 200), Chunk("IEND")), [0, 200] },
        { Png(Header(2, 1, 8, 6, interlacing: 1), Data(0, 1, 2, 3, 0, 0, 4, 5, 6, 200), Chunk("IEND")), [0, 200] },
        { Png(Header(2, 1, 8, 4), Data(0, 1, 9, 2, 255), Chunk("IEND")), [9, 255] },
        { Png(Header(1, 1, 16, 4), Data(0, 1, 2, 128, 128), Chunk("IEND")), [128] },
        { Png(Header(2, 1, 8, 3), Chunk("PLTE", 1, 2, 3, 4, 5, 6), Chunk("tRNS", 7), Data(0, 0, 1), Chunk("IEND")), [7, 255] },
        { Png(Header(2, 1, 8, 6), Data(0, 1, 2, 3, 255, 4, 5, 6, 255), Chunk("IEND")), null },
        { Png(Header(1, 1, 8, 2), Data(0, 1, 2, 3), Chunk("IEND")), null },
    };

    [Theory]
    [MemberData(nameof(Files))]
    public void IsReadUnlessAllIsOpaque(byte[] file, byte[]? values)
    {
        PictureFile.Read(new MemoryStream(file), null, out var alpha);
        Assert.Equal(values, alpha?.Values);
    }
}
