using static RayCaster.Files.Tests.Pictures.TestPng;

namespace RayCaster.Files.Tests.Pictures;

/// <summary>Alpha is not compared: a file in which it hides pixels is warned of.</summary>
public sealed class AlphaTests : InTemporaryFolder
{
    public static TheoryData<byte[], string> Files => new()
    {
        { Png(Header(2, 1, 8, 6), Data(0, 1, 2, 3, 0, 4, 5, 6, 200), Chunk("IEND")), "0 instead of 255 in 2 of 2" },
        { Png(Header(2, 1, 8, 6, interlacing: 1), Data(0, 1, 2, 3, 0, 0, 4, 5, 6, 200), Chunk("IEND")), "0 instead of 255 in 2 of 2" },
        { Png(Header(2, 1, 8, 4), Data(0, 1, 9, 2, 255), Chunk("IEND")), "9 instead of 255 in 1 of 2" },
        { Png(Header(1, 1, 16, 4), Data(0, 1, 2, 128, 128), Chunk("IEND")), "128 instead of 255 in 1 of 1" },
        { Png(Header(2, 1, 8, 3), Chunk("PLTE", 1, 2, 3, 4, 5, 6), Chunk("tRNS", 7), Data(0, 0, 1), Chunk("IEND")), "7 instead of 255 in 1 of 2" },
        { Png(Header(2, 1, 8, 2), Chunk("tRNS", 0, 1, 0, 2, 0, 3), Data(0, 1, 2, 3, 1, 2, 4), Chunk("IEND")), "0 instead of 255 in 1 of 2" },
        { Png(Header(2, 1, 8, 0), Chunk("tRNS", 0, 9), Data(0, 9, 8), Chunk("IEND")), "0 instead of 255 in 1 of 2" },
        { Png(Header(2, 1, 8, 6), Data(0, 1, 2, 3, 255, 4, 5, 6, 255), Chunk("IEND")), "" },
        { Png(Header(1, 1, 8, 2), Data(0, 1, 2, 3), Chunk("IEND")), "" },
    };

    [Theory]
    [MemberData(nameof(Files))]
    public void AFileThatHidesPixelsIsWarnedOf(byte[] file, string told)
    {
        File.WriteAllBytes(folder["a.png"], file);
        var warnings = new List<string>();
        PictureFile.Read(folder["a.png"], warnings.Add);
        Assert.Equal(told == "" ? [] : [
            $"{folder["a.png"]}: warning: its alpha is {told} pixels: a viewer shows what lies behind. Write 255, or no alpha"], warnings);
    }
}
