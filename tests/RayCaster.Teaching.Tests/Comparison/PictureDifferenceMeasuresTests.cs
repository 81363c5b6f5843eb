namespace RayCaster.Teaching.Tests.Comparison;

/// <summary>The measures are those that ImageMagick gives (Data/make.sh).</summary>
public class PictureDifferenceMeasuresTests
{
    private static readonly string folder = ProjectFolder.PathOf("tests/RayCaster.Teaching.Tests/Comparison/Data");
    private static readonly Dictionary<string, double[]> expected = File.ReadLines(Path.Combine(folder, "measures.txt"))
        .Select(line => line.Split(' '))
        .ToDictionary(words => words[0], words => words[1..].Select(word => double.Parse(word, CultureInfo.InvariantCulture)).ToArray());

    public static TheoryData<string> Names => [.. expected.Keys];

    private static Picture Read(string name) => PictureFile.Read(Path.Combine(folder, name + ".ppm"));

    [Theory]
    [MemberData(nameof(Names))]
    public void EachMeasureIsThatOfImageMagick(string name)
    {
        var difference = new PictureDifference(Read(name), Read("reference"));
        Assert.Equal(expected[name][0], difference.CountBeyond(0));
        Assert.Equal(expected[name][1], difference.Largest / 255.0, 1e-6);
        Assert.Equal(expected[name][2], difference.MeanAbsoluteError / 255, 1e-6);
    }
}
