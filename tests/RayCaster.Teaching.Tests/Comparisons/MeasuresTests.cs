using System.Globalization;

namespace RayCaster.Teaching.Tests.Comparisons;

/// <summary>The measures are those that ImageMagick gives (Data/make.sh).</summary>
public class MeasuresTests
{
    private static readonly string folder = ProjectFolder.PathOf("tests/RayCaster.Teaching.Tests/Comparisons/Data");
    private static readonly Dictionary<string, double[]> expected = File.ReadLines(Path.Combine(folder, "measures.txt"))
        .Select(line => line.Split(' '))
        .ToDictionary(words => words[0], words => words[1..].Select(word => double.Parse(word, CultureInfo.InvariantCulture)).ToArray());

    public static TheoryData<string> Names => [.. expected.Keys];

    private static Picture Read(string name) => PictureFile.Read(Path.Combine(folder, name + ".ppm"));

    private static PictureDifference DifferenceOf(string name) => new(Read(name), Read("reference"));

    [Theory]
    [MemberData(nameof(Names))]
    public void TheCountOfPixelsThatDifferIsThatOfImageMagick(string name) =>
        Assert.Equal(expected[name][0], DifferenceOf(name).CountBeyond(0));

    [Theory]
    [MemberData(nameof(Names))]
    public void TheMaximumIsThatOfImageMagick(string name) => Assert.Equal(expected[name][1], DifferenceOf(name).Largest / 255.0, 1e-6);

    [Theory]
    [MemberData(nameof(Names))]
    public void TheMeanAbsoluteErrorIsThatOfImageMagick(string name) =>
        Assert.Equal(expected[name][2], DifferenceOf(name).MeanAbsoluteError / 255, 1e-6);

    [Theory]
    [MemberData(nameof(Names))]
    public void TheRootMeanSquareErrorIsThatOfImageMagick(string name) =>
        Assert.Equal(expected[name][3], DifferenceOf(name).RootMeanSquareError / 255, 1e-6);
}
