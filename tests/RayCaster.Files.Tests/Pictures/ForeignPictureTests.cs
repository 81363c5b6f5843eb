using System.Text;

namespace RayCaster.Files.Tests.Pictures;

/// <summary>Every kind of PNG and PNM that ImageMagick and netpbm write is read to the pixels that they read themselves.</summary>
public class ForeignPictureTests
{
    private static IEnumerable<string> Names =>
        Directory.EnumerateFiles(TestData.Folder).Select(path => Path.GetFileName(path)).Where(IsPicture);

    public static TheoryData<string> Files => [.. Names.Order(StringComparer.Ordinal)];

    [Theory]
    [MemberData(nameof(Files))]
    public void IsReadAsItsWriterReadsIt(string name)
    {
        var expected = TestData.Bytes(name.Split('.')[0] + ".expected.ppm");
        var picture = PictureFile.Read(Path.Combine(TestData.Folder, name));
        var header = Encoding.ASCII.GetBytes($"P6\n{picture.Width} {picture.Height}\n255\n");
        Assert.Equal<byte[]>(expected, [.. header, .. picture.Rgb]);
    }

    [Fact]
    public void NoKindOfPngIsMissing()
    {
        // Bytes 24, 25 and 28 of a PNG are its bit depth, colour type and interlacing.
        var kinds = Names.Select(TestData.Bytes).Where(file => file[0] == 0x89).Select(file => (file[25], file[24], file[28])).Distinct();
        Assert.Equal(15 * 2, kinds.Count());
    }

    private static bool IsPicture(string name) =>
        Path.GetExtension(name) is ".png" or ".ppm" or ".pgm" && !name.Contains(".expected.");
}
