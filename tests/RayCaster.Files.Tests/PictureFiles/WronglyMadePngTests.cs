using System.Buffers.Binary;
using System.IO.Compression;

namespace RayCaster.Files.Tests.PictureFiles;

/// <summary>PNGs with right checksums that are wrong in another way (ISO/IEC 15948, clause 5) are refused, as other programs do.</summary>
public sealed class WronglyMadePngTests : IDisposable
{
    private static readonly byte[] lines = new byte[10 * 31];

    private readonly TemporaryFolder folder = new();

    public void Dispose() => folder.Dispose();

    [Fact]
    public void ARightPngIsRead() => Assert.Equal(10, Read(Data(Zlib)).Width);

    [Fact]
    public void DataMayBeInManyChunks() => Assert.Equal(10, Read([.. Data(Zlib[..5]), .. Data(Zlib[5..])]).Width);

    [Theory]
    [InlineData(1)]
    [InlineData(4)]
    public void DataWithoutTheirChecksumAreRefused(int missing) =>
        Refused("its compressed data do not end with their checksum", Data(Zlib[..^missing]));

    /// <summary>The format's third edition asks for it (11.2.3): programs write their whole buffer.</summary>
    [Fact]
    public void BytesBehindTheDataAreIgnored() => Assert.Equal(10, Read([.. Data([.. Zlib, 1, 2, 3]), .. Data([4, 5]), .. Data(Zlib)]).Width);

    [Fact]
    public void AChunkBehindTheDataHasItsChecksumToo()
    {
        var behind = Data(new byte[100_000]);
        behind[^1] ^= 1;
        Refused("its chunk IDAT at byte 366 is damaged: the checksum is wrong", [.. Data(Zlib), .. behind]);
    }

    [Fact]
    public void DataThatAreCutAreRefused() => Refused("the file is cut short: its data end in line 0 of 10", Data(Zlib[..5]));

    [Fact]
    public void DataInTwoRunsAreRefused() =>
        Refused("its chunks IDAT do not follow one another", [.. Data(Zlib[..5]), .. Chunk("tIME", []), .. Data(Zlib[5..])]);

    [Fact]
    public void APaletteAfterTheDataIsRefused() => Refused("its palette comes after its data", [.. Data(Zlib), .. Chunk("PLTE", [1, 2, 3])]);

    [Fact]
    public void TwoPalettesAreRefused() => Refused("it has two palettes", [.. Chunk("PLTE", [1, 2, 3]), .. Chunk("PLTE", [1, 2, 3]), .. Data(Zlib)]);

    [Fact]
    public void ATypeThatIsNotOfLettersIsRefused() =>
        Refused("its chunk at byte 33 is of the type a1b2, which is not four letters", [.. Chunk("a1b2", []), .. Data(Zlib)]);

    /// <summary>Otherwise the animation would contain damaged data, and no program could show it.</summary>
    [Fact]
    public void AnAnimationRefusesWrongPngs()
    {
        var (good, cut) = (folder.Write("good.png", Png(Data(Zlib))), folder.Write("cut.png", Png(Data(Zlib[..^2]))));
        using var animation = new MemoryStream();
        Assert.Equal($"cannot read {cut}: its compressed data do not end with their checksum",
            Assert.Throws<ProblemException>(() => AnimationFile.Write(animation, [good, cut], 25)).Message);
        animation.SetLength(0);
        AnimationFile.Write(animation, [good, good], 25);
        var film = folder.Write("film.png", animation.ToArray());
        Assert.Equal($"cannot read {film}: it is an animation, not a single picture",
            Assert.Throws<ProblemException>(() => AnimationFile.Write(new MemoryStream(), [film], 25)).Message);
    }

    /// <summary>Otherwise --resume would not draw it again, and stitch could not read it.</summary>
    [Fact]
    public void APartWithCutDataDoesNotCount()
    {
        var facts = new PartFacts(10, 10, LineRange.Whole(10), "digest", "1.0.0");
        var text = Chunk(
            "tEXt", [.. System.Text.Encoding.ASCII.GetBytes(PngChunk.PartKeyword), 0, .. System.Text.Encoding.ASCII.GetBytes(facts.ToString())]);
        Assert.True(PartFile.Holds(folder.Write("good.png", Png([.. text, .. Data(Zlib)])), facts, out _));
        Assert.False(PartFile.Holds(folder.Write("cut.png", Png([.. text, .. Data(Zlib[..^6])])), facts, out var reason));
        Assert.Contains("the file is cut short", reason);
    }

    private static byte[] Zlib
    {
        get
        {
            var data = new MemoryStream();
            using (var zlib = new ZLibStream(data, CompressionLevel.NoCompression, leaveOpen: true)) zlib.Write(lines);
            return data.ToArray();
        }
    }

    private static byte[] Data(byte[] data) => Chunk("IDAT", data);

    private static byte[] Chunk(string type, byte[] data)
    {
        var chunk = new MemoryStream();
        PngChunk.Write(chunk, System.Text.Encoding.ASCII.GetBytes(type), data);
        return chunk.ToArray();
    }

    private static byte[] Png(byte[] chunks)
    {
        var header = new byte[13];
        BinaryPrimitives.WriteInt32BigEndian(header, 10);
        BinaryPrimitives.WriteInt32BigEndian(header.AsSpan(4), 10);
        (header[8], header[9]) = (8, 2);
        return [.. PngChunk.Signature, .. Chunk("IHDR", header), .. chunks, .. Chunk("IEND", [])];
    }

    private static Picture Read(byte[] chunks) => PictureFile.Read(new MemoryStream(Png(chunks)));

    private static void Refused(string message, byte[] chunks) =>
        Assert.Equal(message, Assert.Throws<ProblemException>(() => Read(chunks)).Message);
}
