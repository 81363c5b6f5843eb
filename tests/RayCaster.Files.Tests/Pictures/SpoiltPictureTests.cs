using System.Text;

namespace RayCaster.Files.Tests.Pictures;

/// <summary>Pictures as other programs spoil them: the message names what the program did, and the cure.</summary>
public sealed class SpoiltPictureTests : InTemporaryFolder
{
    private static readonly byte[] colors = [10, 20, 30, 40, 50, 60, 70, 80, 90, 10, 200, 130];

    private const string TextMode = "each byte 0A has become two, 0D 0A; open the file in binary mode (\"wb\", ios::binary)";

    public static TheoryData<string, byte[], string> BytesThatAreTooMany => new()
    {
        { "P6\r\n2 2\r\n255\r\n", InTextMode(colors), $"3 bytes more than its header promises: {TextMode}" },
        { "P6\n2 2\n255\n", InTextMode(colors), $"2 bytes more than its header promises: {TextMode}" },
        { "P5\n3 4\n255\n", InTextMode(colors), $"2 bytes more than its header promises: {TextMode}" },
        { "P6\n1 2\n65535\n", InTextMode(colors), $"2 bytes more than its header promises: {TextMode}" },
        {
            "P6\n2 2\n255\n", [10, 20, 30, 255, 40, 50, 60, 255, 70, 80, 90, 255, 10, 200, 130, 255],
            "4 bytes more than its header promises: it has four bytes a pixel; a pixel of P6 has red, green and blue, no alpha"
        },
        { "P6\n2 2\n255\n", new byte[96], "84 bytes more than its header promises: it has 24 bytes a pixel; a pixel of P6 has 3" },
        {
            "P6\n2 2\n255\n", Encoding.ASCII.GetBytes("10 20 30 40 50 60 70 80 90 10 200 130\n"),
            "26 bytes more than its header promises: the pixels are a text, and P6 announces bytes; the header for a text is P3"
        },
        { "P5\n2 2\n255\n", colors, "8 bytes more than its header promises: P5 is grey, one byte a pixel; the header for colours is P6" },
        {
            "P6\n2 2\n255\n", [10, 20, 30, 40, 50, 60, 70, 80, 90, 10, 0xC3, 0x88, 0xC2, 0x82],
            "2 bytes more than its header promises: each byte above 127 has become two or more: "
                + "write bytes to a stream, not characters or a redirected text"
        },
        {
            "P6\n1 2\n255\n", [1, 2, 3, 0, 4, 5, 6, 0],
            "2 bytes more than its header promises: it has four bytes a pixel; a pixel of P6 has red, green and blue, no alpha"
        },
        {
            "P6\n3 2\n255\n", new byte[24],
            "6 bytes more than its header promises: it has four bytes a pixel; a pixel of P6 has red, green and blue, no alpha"
        },
        {
            "P6\n5 2\n255\n", new byte[32],
            "2 bytes more than its header promises: each line is filled up to a multiple of 4 bytes; a line of PPM is not"
        },
        {
            "P6\n4 2\n255\n", new byte[30],
            "6 bytes more than its header promises: as many as one column more takes: does the loop over columns run once too often?"
        },
    };

    [Theory]
    [MemberData(nameof(BytesThatAreTooMany))]
    public void TheMessageSaysHowTheBytesBecameTooMany(string header, byte[] bytes, string message) =>
        Assert.Equal($"cannot read {folder["mine.ppm"]}: the file has {message}", Refused(Encoding.ASCII.GetBytes(header), bytes));

    [Theory]
    [InlineData("P6\n2 2\n255\n", 15, "the file has 3 bytes more than its header promises; they are ignored")]
    [InlineData("P6\n2 2\n255\n", 13, null)] // a line end at the end
    public void WhatIsBehindThePixelsIsIgnored(string header, int count, string? warning)
    {
        byte[] bytes = [.. colors, (byte)'\n', 1, 2];
        var (picture, words) = Read(Encoding.ASCII.GetBytes(header), bytes[..count]);
        Assert.Equal(colors, picture.Rgb);
        Assert.Equal(warning is null ? [] : [$"{folder["mine.ppm"]}: warning: {warning}"], words);
    }

    [Fact]
    public void AnotherPictureMayFollow()
    {
        var (picture, words) = Read("P6\n2 2\n255\n"u8, [.. colors, .. "P6\n2 2\n255\n"u8, .. colors]);
        Assert.Equal(colors, picture.Rgb);
        Assert.Empty(words);
    }

    /// <summary>The classic slip moves all colours by a byte. It is a known mistake, so the picture is read.</summary>
    [Fact]
    public void AHeaderThatEndsWithTwoBytesIsNamedAndRead()
    {
        var (picture, words) = Read("P6\n2 2\n255\r\n"u8, [1, 2, 3, 4, 5, 6, 7, 8, 9, 11, 200, 130]);
        Assert.Equal([10, 1, 2, 3], picture.Rgb[..4]);
        Assert.EndsWith("1 byte more than its header promises: the header ends with 0D 0A, of which only 0D belongs to it; end it with \"\\n\", "
            + "and open the file in binary mode", Assert.Single(words));
    }

    [Theory]
    [InlineData("P6\n2 2\n256\n", "; maxval is 256, and above 255 a value takes two bytes: write 255")]
    [InlineData("P6\n4 3\n255\n", "; it has one byte a pixel; the header for grey is P5")]
    [InlineData("P3\n2 2\n255\n", "; bytes follow the header, and P3 announces a text; the header for bytes is P6")]
    [InlineData("P6\n7 2\n255\n", "42 bytes after the header, but there are 12")]
    public void TheMessageSaysHowTheBytesBecameTooFew(string header, string message)
    {
        var refused = Refused(Encoding.ASCII.GetBytes(header), colors);
        Assert.StartsWith($"cannot read {folder["mine.ppm"]}: the file is cut short", refused);
        Assert.EndsWith(message, refused);
    }

    [Fact]
    public void OneValueTooManyIsAWarning()
    {
        var (picture, words) = Read("P3 1 2 255 1 2 3 1 2 3 # end\n 9\n"u8, []);
        Assert.Equal([1, 2, 3, 1, 2, 3], picture.Rgb);
        Assert.Equal([$"{folder["mine.ppm"]}: warning: the file has 1 value more than its header promises; they are ignored"], words);
    }

    [Theory]
    [InlineData(false, true, "P3\r\n1 1\r\n255\r\n1 2 3\r\n")]
    [InlineData(true, true, "P6\r\n1 1\r\n255\r\nabc")]
    [InlineData(false, false, "P6\n1 1\n255\nabc")]
    public void Utf16IsNamedWithItsCure(bool bigEndian, bool hasMark, string text)
    {
        var encoding = new UnicodeEncoding(bigEndian, hasMark);
        Assert.Equal($"cannot read {folder["mine.ppm"]}: the file is in UTF-16, as PowerShell's > writes it: "
            + "let the program write the file itself, or redirect in cmd", Refused(encoding.GetPreamble(), encoding.GetBytes(text)));
    }

    [Theory]
    [InlineData("P3 1 1 255 97 98 99")]
    [InlineData("P6 1 1 255 abc")]
    public void AByteOrderMarkIsSkipped(string text)
    {
        var (picture, words) = Read("\uFEFF"u8, Encoding.ASCII.GetBytes(text));
        Assert.Equal("abc"u8, picture.Rgb);
        Assert.Empty(words);
    }

    public static TheoryData<byte[], string> OtherKinds => new()
    {
        { [.. "RIFF"u8, 1, 2, 3, 4, .. "WEBPVP8 "u8], "it is a WebP" },
        { [.. "II*\0"u8, 8, 0, 0, 0], "it is a TIFF" },
        { [.. "MM\0*"u8, 0, 0, 0, 8], "it is a TIFF" },
        { [0x1F, 0x8B, 8, 0], "it is compressed (gzip); unpack it first" },
        { [.. "PK"u8, 3, 4, 20, 0], "it is a zip archive; unpack it first" },
        { [.. "\r\n<!DOCTYPE html>\n"u8], "it is a web page (HTML), saved in place of the file" },
        { [.. "%PDF-1.7"u8], "it is a PDF" },
        { [.. "8BPS"u8, 0, 1], "it is a picture of Photoshop (PSD)" },
        { [0, 0, 0, 0x18, .. "ftypheic"u8, 0], "it is an HEIC picture or a film" },
        { [.. "BM"u8, 1, 2, 3], "it is a BMP" },
        { [.. "GIF89a"u8], "it is a GIF" },
    };

    [Theory]
    [MemberData(nameof(OtherKinds))]
    public void AnotherKindOfFileIsNamed(byte[] bytes, string kind) =>
        Assert.Equal($"cannot read {folder["mine.ppm"]}: {kind}; PNG, PGM and PPM can be read", Refused(bytes, []));

    private static byte[] InTextMode(byte[] bytes) => [.. bytes.SelectMany(value => value == 10 ? (byte[])[13, 10] : [value])];

    private (Picture, List<string>) Read(ReadOnlySpan<byte> header, byte[] bytes)
    {
        var words = new List<string>();
        return (PictureFile.Read(folder.Write("mine.ppm", [.. header, .. bytes]), words.Add), words);
    }

    private string Refused(ReadOnlySpan<byte> header, byte[] bytes)
    {
        folder.Write("mine.ppm", [.. header, .. bytes]);
        return Assert.Throws<ProblemException>(() => PictureFile.Read(folder["mine.ppm"])).Message;
    }
}
