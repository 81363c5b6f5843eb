using System.Text;

namespace RayCaster.Files.Tests.Pictures;

public class PictureWriterTests
{
    public static TheoryData<PictureFormat, int, int> Pictures
    {
        get
        {
            var data = new TheoryData<PictureFormat, int, int>();
            foreach (var format in Enum.GetValues<PictureFormat>())
                foreach (var (width, height) in new[] { (1, 1), (1, 300), (300, 1), (5, 2), (6, 2), (37, 23), (641, 481) })
                    data.Add(format, width, height);
            return data;
        }
    }

    [Theory]
    [MemberData(nameof(Pictures))]
    public void WhatIsWrittenIsReadBack(PictureFormat format, int width, int height)
    {
        var picture = Noise(width, height);
        var read = PictureFile.Read(new MemoryStream(Encode(format, picture, linesAtOnce: height)));
        Assert.Equal((width, height), (read.Width, read.Height));
        Assert.Equal(picture.Rgb, read.Rgb);
    }

    [Theory]
    [InlineData(PictureFormat.Png)]
    [InlineData(PictureFormat.Ppm)]
    [InlineData(PictureFormat.PpmText)]
    public void TheFileDoesNotDependOnHowManyLinesComeAtOnce(PictureFormat format)
    {
        var picture = Noise(37, 24);
        Assert.Equal(Encode(format, picture, linesAtOnce: 24), Encode(format, picture, linesAtOnce: 1));
        Assert.Equal(Encode(format, picture, linesAtOnce: 24), Encode(format, picture, linesAtOnce: 8));
    }

    [Fact]
    public void PpmInTextIsFiveOfThePicturesPixelsOnALine()
    {
        var picture = new Picture(6, 2);
        picture[0, 0] = (255, 0, 7);
        picture[5, 1] = (1, 20, 255);
        var zeros = "0 0 0";
        Assert.Equal(
            $"P3\n6 2\n255\n255 0 7 {zeros} {zeros} {zeros} {zeros}\n{zeros}\n{zeros} {zeros} {zeros} {zeros} {zeros}\n1 20 255\n",
            Encoding.ASCII.GetString(Encode(PictureFormat.PpmText, picture, linesAtOnce: 2)));
    }

    [Fact]
    public void PpmIsItsHeaderAndItsBytes()
    {
        var picture = Noise(2, 3);
        Assert.Equal([.. "P6\n2 3\n255\n"u8, .. picture.Rgb], Encode(PictureFormat.Ppm, picture, linesAtOnce: 1));
    }

    [Fact]
    public void APictureIsAllItsLinesAndEndsOnce()
    {
        using var writer = PictureWriter.Create(PictureFormat.Png, Stream.Null, 2, 3);
        Assert.Throws<ArgumentException>(() => writer.WriteRows(new byte[7])); // a part of a line
        writer.WriteRows(new byte[12]);
        Assert.Throws<InvalidOperationException>(writer.Finish);
        Assert.Throws<InvalidOperationException>(() => writer.WriteRows(new byte[12]));
        writer.WriteRows(new byte[6]);
        writer.Finish();
        Assert.Throws<InvalidOperationException>(writer.Finish);
    }

    [Fact]
    public void AnUnfinishedWriterLeavesNoWholePng()
    {
        var output = new MemoryStream();
        using (var writer = PictureWriter.Create(PictureFormat.Png, output, 1, 1)) writer.WriteRows(new byte[3]);
        output.Position = 0;
        Assert.Throws<ProblemException>(() => PictureFile.Read(output));
    }

    [Theory]
    [InlineData("a/room.png", PictureFormat.Png)]
    [InlineData("ROOM.PNG", PictureFormat.Png)]
    [InlineData("room.v2.Ppm", PictureFormat.Ppm)]
    public void TheExtensionChoosesTheFormat(string path, PictureFormat format) => Assert.Equal(format, PictureFile.FormatOf(path));

    [Theory]
    [InlineData("room.jpg", "no picture format for 'room.jpg': .jpg is not known; use .png or .ppm")]
    [InlineData("a.png/room", "no picture format for 'a.png/room': the name has no extension; use .png or .ppm")]
    public void AnotherExtensionIsAnErrorThatNamesTheAllowedOnes(string path, string message) =>
        Assert.Equal(message, Assert.Throws<ProblemException>(() => PictureFile.FormatOf(path)).Message);

    /// <summary>Half noise, which does not compress, half one colour, which does.</summary>
    internal static Picture Noise(int width, int height)
    {
        var picture = new Picture(width, height);
        new Random(width * 1000 + height).NextBytes(picture.Rgb.AsSpan(0, (picture.Rgb.Length + 1) / 2));
        return picture;
    }

    internal static byte[] Encode(PictureFormat format, Picture picture, int linesAtOnce)
    {
        var output = new MemoryStream();
        using var writer = PictureWriter.Create(format, output, picture.Width, picture.Height);
        foreach (var lines in picture.Rgb.Chunk(picture.Width * 3 * linesAtOnce)) writer.WriteRows(lines);
        writer.Finish();
        return output.ToArray();
    }
}
