using System.Globalization;

namespace RayCaster.Teaching.Tests.Comparisons;

/// <summary>The measures are those that ImageMagick and the plain definition of SSIM give (Data/make.sh).</summary>
public class MeasuresTests
{
    private static readonly string folder = ProjectFolder.PathOf("tests/RayCaster.Teaching.Tests/Comparisons/Data");
    private static readonly Dictionary<string, double[]> expected = File.ReadLines(Path.Combine(folder, "measures.txt"))
        .Select(line => line.Split(' '))
        .ToDictionary(words => words[0], words => words[1..].Select(word => double.Parse(word, CultureInfo.InvariantCulture)).ToArray());

    public static TheoryData<string> Names => [.. expected.Keys];

    private static Picture Read(string name) => PictureFile.Read(Path.Combine(folder, name + ".ppm"));

    private static Measures MeasuresOf(string name) => new(new PictureDifference(Read(name), Read("reference")));

    [Theory]
    [MemberData(nameof(Names))]
    public void TheCountOfPixelsThatDifferIsThatOfImageMagick(string name) =>
        Assert.Equal(expected[name][0], new PictureDifference(Read(name), Read("reference")).CountBeyond(0));

    [Theory]
    [MemberData(nameof(Names))]
    public void TheMaximumIsThatOfImageMagick(string name) => Assert.Equal(expected[name][1], MeasuresOf(name).Maximum / 255.0, 1e-6);

    [Theory]
    [MemberData(nameof(Names))]
    public void TheMeanAbsoluteErrorIsThatOfImageMagick(string name) =>
        Assert.Equal(expected[name][2], MeasuresOf(name).MeanAbsoluteError / 255, 1e-6);

    [Theory]
    [MemberData(nameof(Names))]
    public void TheRootMeanSquareErrorIsThatOfImageMagick(string name) =>
        Assert.Equal(expected[name][3], MeasuresOf(name).RootMeanSquareError / 255, 1e-6);

    [Theory]
    [MemberData(nameof(Names))]
    public void ThePeakSignalToNoiseRatioIsThatOfImageMagick(string name) =>
        Assert.Equal(expected[name][4], MeasuresOf(name).PeakSignalToNoiseRatio, 1e-4);

    [Theory]
    [MemberData(nameof(Names))]
    public void TheStructuralSimilarityIsThatOfItsDefinition(string name) =>
        Assert.Equal(expected[name][5], MeasuresOf(name).StructuralSimilarity, 1e-9);

    [Fact]
    public void IdenticalPicturesHaveAnInfiniteRatio()
    {
        var measures = MeasuresOf("reference");
        Assert.Equal((0, 0.0, double.PositiveInfinity), (measures.Maximum, measures.RootMeanSquareError, measures.PeakSignalToNoiseRatio));
        Assert.Equal(1, measures.StructuralSimilarity, 1e-12);
        Assert.Contains("PSNR infinite", ComparisonText.Of(measures));
    }

    [Theory]
    [InlineData(1, 1)]
    [InlineData(3, 40)]
    [InlineData(40, 3)]
    public void PicturesSmallerThanAWindowHaveASimilarityToo(int width, int height)
    {
        var picture = SomePictures.Make(width, height, (x, y) => ((byte)(7 * x), (byte)(5 * y), (byte)(x * y)));
        Assert.Equal(1, new Measures(new(picture, picture)).StructuralSimilarity, 1e-12);
    }
}
