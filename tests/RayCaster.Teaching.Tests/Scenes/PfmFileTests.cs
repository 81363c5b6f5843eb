using System.Text;

namespace RayCaster.Teaching.Tests.Scenes;

public class PfmFileTests
{
    [Theory]
    [InlineData("grey-little.netpbm.pfm", 3, 2, 1, new[] { 0, 0.25f, 0.5f, 0.75f, 1, 0.5f })]
    [InlineData("colours.netpbm.pfm", 2, 2, 3, new[] { 0, 0.25f, 0.5f, 0.75f, 1, 0, 1, 0.75f, 0.5f, 0.25f, 0, 1 })]
    public void AMapIsWrittenAsNetpbmWritesIt(string name, int width, int height, int channels, float[] numbers)
    {
        var foreign = ProjectFolder.PathOf("tests/RayCaster.Teaching.Tests/Scenes/Data/" + name);
        Assert.Equal(Encoding.Latin1.GetString(File.ReadAllBytes(foreign)).Replace("-1.000000", "-1.0"),
            Encoding.Latin1.GetString(Written(new(width, height, channels), numbers)));
    }

    [Fact]
    public void InfinityAndAllDigitsAreWritten()
    {
        float[] numbers = [float.PositiveInfinity, -1, float.Epsilon, 12.3456789f];
        var file = Written(new(4, 1, 1), numbers);
        Assert.Equal(numbers, Enumerable.Range(0, 4).Select(i => BitConverter.ToSingle(file, "Pf\n4 1\n-1.0\n".Length + 4 * i)));
    }

    private static byte[] Written(NumberMap map, float[] numbers)
    {
        numbers.CopyTo(map.Values, 0);
        using var stream = new MemoryStream();
        PfmFile.Write(stream, map);
        return stream.ToArray();
    }
}
