using System.Text;
using RayCaster.Files.Tests.Fuzzing;
using static RayCaster.Files.Tests.Pictures.TestPng;

namespace RayCaster.Files.Tests.Pictures;

/// <summary>A damaged or hostile file is refused with a message: never a crash, never memory for what a header promises.</summary>
public class BrokenPictureTests
{
    [Theory]
    [InlineData("grey-1.netpbm.png")]
    [InlineData("size-3x5.imagemagick-adam7.png")]
    [InlineData("palette-4.netpbm-transparent.png")]
    [InlineData("greymap-1000.netpbm-p5.pgm")]
    [InlineData("pixmap-255.imagemagick-p6.ppm")]
    public void ACutFileIsRefusedWhereverItIsCut(string name)
    {
        var file = TestData.Bytes(name);
        for (var length = 0; length < file.Length; length++) Refused(file[..length]);
    }

    [Theory]
    [InlineData("greymap-5.netpbm-p2.pgm")]
    [InlineData("pixmap-255.imagemagick-p3.ppm")]
    public void ACutTextIsRefusedUpToItsLastNumber(string name)
    {
        var file = Encoding.ASCII.GetBytes(Encoding.ASCII.GetString(TestData.Bytes(name)).TrimEnd());
        var lastNumber = file.AsSpan().LastIndexOfAny((byte)' ', (byte)'\n') + 1;
        for (var length = 0; length <= lastNumber; length++) Refused(file[..length]);
    }

    [Theory]
    [InlineData("grey-1.netpbm.png")]
    [InlineData("palette-2.imagemagick-adam7.png")]
    [InlineData("rgb-8.netpbm-paeth.png", Explicit = true)]
    public void AFlippedByteOfAPngIsNoticed(string name)
    {
        var file = TestData.Bytes(name);
        for (var i = 0; i < file.Length; i++)
        {
            foreach (var flip in new byte[] { 0xFF, 0x01, 0x20, 0x80 })
            {
                file[i] ^= flip;
                Assert.NotEmpty(WordsOn(file));
                file[i] ^= flip;
            }
        }
    }

    public static TheoryData<byte[], string> Broken => new()
    {
        { [], "the file is empty" },
        { [0xFF, 0xD8, 0xFF], "it is a JPEG, whose colours are not exact; PNG, PGM and PPM can be read" },
        {
            [0x89, (byte)'P', (byte)'N', (byte)'G', (byte)'\n'],
            "it begins like a PNG, but its first eight bytes are damaged; was it written or transferred as text? Open the file in binary mode"
        },
        { Png(Chunk("CgBI", 1, 2, 3, 4), Header(1, 1, 8, 2)), "its first chunk is CgBI instead of IHDR" },
        { Png(Chunk("IHDR", 1, 2, 3)), "its chunk IHDR has 3 bytes instead of 13" },
        { Png(Header(1, 1, 8, 5)), "its colour type is 5, but must be 0, 2, 3, 4 or 6" },
        { Png(Header(1, 1, 4, 2)), "its bit depth is 4, which colour type 2 does not allow" },
        { Png(Header(1, 1, 16, 3)), "its bit depth is 16, which colour type 3 does not allow" },
        { Png(Header(1, 1, 8, 2, interlacing: 2)), "its interlace method is 2, but must be 0 or 1" },
        { Png(Header(0, 1, 8, 2)), "its size is 0 × 1 pixels, but each side must be at least 1" },
        { Png(Header(1, 1, 8, 2), Header(1, 1, 8, 2)), "its chunk IHDR is unknown or in the wrong place" },
        { Png(Header(1, 1, 8, 2), Chunk("ABCD")), "its chunk ABCD is unknown or in the wrong place" },
        { Png(Header(1, 1, 8, 3), Data(0, 0), Chunk("IEND")), "its palette has 0 bytes, but must be 1 to 256 colours of 3 bytes" },
        { Png(Header(1, 1, 8, 3), Chunk("PLTE", 1, 2, 3), Data(0, 1), Chunk("IEND")), "a pixel has colour 1 of a palette that has 1" },
        { Png(Header(1, 1, 8, 2), Data(5, 1, 2, 3), Chunk("IEND")), "a line has filter 5, but there are only 0 to 4" },
        { Png(Header(1, 1, 8, 2), Data(0, 1, 2), Chunk("IEND")), "the file is cut short: its data end in line 0 of 1" },
        { Png(Header(1, 1, 8, 2), Data(0, 1, 2, 3, 4), Chunk("IEND")), "it holds more data than its pixels need" },
        { Png(Header(1, 1, 8, 2), Chunk("IDAT", 1, 2, 3), Chunk("IEND")), "its compressed data are damaged" },
        { Png(Header(1, 1, 8, 2), Chunk("IEND")), "it has no pixels: there is no chunk IDAT" },
        { Png(Header(1, 1, 8, 2), Chunk("IDAT", Compress(0, 1, 2, 3)[..^1]), Chunk("IEND")), "its compressed data do not end with their checksum" },
        { Png(Header(1, 1, 8, 2), Chunk("IDAT", Compress(0, 1, 2, 3)[..^4]), Chunk("IEND")), "its compressed data do not end with their checksum" },
        { Png(Header(1, 1, 8, 2), Data(0, 1, 2, 3), Spoilt(Data(0)), Chunk("IEND")), "its chunk IDAT at byte 57 is damaged: the checksum is wrong" },
        { Png(Header(1, 1, 8, 2), Data(0, 1, 2, 3), Chunk("tIME"), Data(0), Chunk("IEND")), "its chunks IDAT do not follow one another" },
        { Png(Header(1, 1, 8, 2), Data(0, 1, 2, 3), Chunk("PLTE", 1, 2, 3), Chunk("IEND")), "its palette comes after its data" },
        { Png(Header(1, 1, 8, 3), Chunk("PLTE", 1, 2, 3), Chunk("PLTE", 1, 2, 3), Data(0, 0), Chunk("IEND")), "it has two palettes" },
        { Png(Header(1, 1, 8, 2), Chunk("a1b2")), "its chunk at byte 33 is of the type a1b2, which is not four letters" },
        {
            "version https://git-lfs.github.com/spec/v1\noid sha256:12\nsize 9\n"u8.ToArray(),
            "it is only a Git LFS pointer to the file (fetch the file itself: git lfs pull); PNG, PGM and PPM can be read"
        },
        { Png(Header(1, 1, 8, 2)), "the file is cut short: it ends at byte 33, before its chunk IEND" },
        {
            Png(Header(int.MaxValue, int.MaxValue, 8, 2), Data(0), Chunk("IEND")),
            "a picture of 2,147,483,647 × 2,147,483,647 pixels needs 13,835,058,042,397,261,827 bytes, the limit is 2,147,483,591"
        },
        {
            Png(Header(500_000_000, 1, 16, 6), Data(0), Chunk("IEND")),
            "its lines have 500,000,000 pixels, the limit is 1,000,000"
        },
        {
            Png(Header(26000, 26000, 1, 0), Chunk("IDAT", 1, 2, 3), Chunk("IEND")),
            "the file is cut short: 26,000 × 26,000 pixels are 84,526,000 bytes, which cannot be compressed to the 3 that the file holds"
        },
        {
            [.. Png(), 0xFF, 0xFF, 0xFF, 0xFF, .. "IHDR"u8, 0, 0, 0, 0],
            "the file is cut short: its chunk IHDR at byte 8 needs 4,294,967,295 bytes, but 0 follow"
        },
    };

    [Theory]
    [MemberData(nameof(Broken))]
    public void TheMessageSaysWhatIsWrong(byte[] file, string message)
    {
        var before = GC.GetAllocatedBytesForCurrentThread();
        Assert.Equal(message, Refused(file).Message);
        Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 0, 1_000_000);
    }

    public static TheoryData<string> BrokenTextFiles => BrokenTexts.Rows("Pictures.txt");

    [Theory]
    [MemberData(nameof(BrokenTextFiles))]
    public void TheMessageSaysWhatIsWrongInAText(string row)
    {
        var columns = BrokenTexts.Columns("Pictures.txt", row);
        TheMessageSaysWhatIsWrong(Encoding.Latin1.GetBytes(columns[0]), columns[1]);
    }

    [Fact]
    public void ChecksumsOfThePixelsThemselvesAreChecked()
    {
        var data = Compress(0, 1, 2, 3);
        data[^1] ^= 1;
        Assert.Equal("its compressed data are damaged", Refused(Png(Header(1, 1, 8, 2), Chunk("IDAT", data), Chunk("IEND"))).Message);
    }

    [Fact]
    public void DataMayBeSplitAnywhere()
    {
        var data = Compress(0, 1, 2, 3);
        var file = Png([Header(1, 1, 8, 2), .. data.Select(value => Chunk("IDAT", value)), Chunk("IEND")]);
        Assert.Equal([1, 2, 3], PictureFile.Read(new MemoryStream(file)).Rgb);
    }

    /// <summary>The format's third edition asks for it (11.2.3): programs write their whole buffer.</summary>
    [Fact]
    public void BytesBehindTheDataAreIgnored()
    {
        var file = Png(Header(1, 1, 8, 2), Chunk("IDAT", [.. Compress(0, 1, 2, 3), 1, 2, 3]), Chunk("IDAT", 4, 5), Data(0), Chunk("IEND"));
        Assert.Equal([1, 2, 3], PictureFile.Read(new MemoryStream(file)).Rgb);
    }

    [Fact]
    public void APipeIsReadToItsEnd()
    {
        var file = TestData.Bytes("rgb-8.netpbm.png");
        using var pipe = new Pipe(file);
        Assert.Equal(PictureFile.Read(new MemoryStream(file)).Rgb, PictureFile.Read(pipe).Rgb);
    }

    [Fact]
    public void APipeOfSomethingElseIsNotReadToItsEnd()
    {
        using var pipe = new Pipe(new byte[5000]);
        Assert.Throws<ProblemException>(() => PictureFile.Read(pipe));
        Assert.Equal(FileSignature.Bytes, pipe.Given);
    }

    [Fact]
    public void TheMessageNamesTheFile()
    {
        using var folder = new TemporaryFolder();
        var path = folder.Write("mine.png", "hello"u8);
        Assert.StartsWith($"cannot read {path}: it begins with 'hello'", RefusedFile(path));
        Assert.Equal($"cannot read {folder.Path}: it is a folder, not a picture", RefusedFile(folder.Path));
        Assert.Equal($"picture file not found: no/such.png\n  looked for {Path.GetFullPath("no/such.png")}", RefusedFile("no/such.png"));
    }

    /// <summary>The format says that a reader goes on where the pixels do not need the chunk (13.2).</summary>
    [Fact]
    public void AWrongChecksumOfAChunkThatThePixelsDoNotNeedIsAWarning()
    {
        var file = Png(Header(1, 1, 8, 2), Spoilt(Chunk("tEXt", "Comment\0x"u8.ToArray())), Data(0, 1, 2, 3), Spoilt(Chunk("tIME")), Chunk("IEND"));
        var place = file.AsSpan().IndexOf("tIME"u8) - 4;
        using var folder = new TemporaryFolder();
        var path = folder.Write("mine.png", file);
        var words = new List<string>();
        Assert.Equal([1, 2, 3], PictureFile.Read(path, words.Add).Rgb);
        Assert.Equal(
            [$"{path}: warning: its chunk tEXt at byte 33 is damaged: the checksum is wrong; the pixels do not need it",
             $"{path}: warning: its chunk tIME at byte {place} is damaged: the checksum is wrong; the pixels do not need it"], words);
    }

    /// <summary>Which lines of a whole a part shows is not taken from a damaged text.</summary>
    [Fact]
    public void ADamagedTextIsNotReadAsAPart()
    {
        var text = Chunk("tEXt", [.. "key\0x"u8]);
        Assert.Equal("x", TextIn(text));
        Assert.Null(TextIn(Spoilt(text)));

        static string? TextIn(byte[] text) =>
            new PngReader(new MemoryStream(Png(Header(1, 1, 8, 2), text, Data(0, 1, 2, 3), Chunk("IEND"))), 100, keyword: "key").Text;
    }

    private static byte[] Spoilt(byte[] chunk)
    {
        chunk[^1] ^= 1;
        return chunk;
    }

    /// <summary>The error or the warnings for a file.</summary>
    private static List<string> WordsOn(byte[] file)
    {
        var words = new List<string>();
        if (Record.Exception(() => PngReader.Read(new MemoryStream(file), PictureFile.MaxBytes, words.Add)) is { } error)
            words.Add(Assert.IsType<ProblemException>(error).Message);
        return words;
    }

    private static ProblemException Refused(byte[] file) =>
        Assert.Throws<ProblemException>(() => PictureFile.Read(new MemoryStream(file)));

    private static string RefusedFile(string path) => Assert.Throws<ProblemException>(() => PictureFile.Read(path)).Message;
}
