using System.Text;

namespace RayCaster.Teaching.Tests.Visibility;

public class PfmFileTests
{
    [Fact]
    public void AMapIsWrittenAsNetpbmWritesIt()
    {
        var foreign = ProjectFolder.PathOf("tests/RayCaster.Teaching.Tests/Visibility/Data/grey-little.netpbm.pfm");
        Assert.Equal(Encoding.Latin1.GetString(File.ReadAllBytes(foreign)).Replace("-1.000000", "-1.0"),
            Encoding.Latin1.GetString(Written(new(3, 2), [0, 0.25f, 0.5f, 0.75f, 1, 0.5f])));
    }

    [Fact]
    public void InfinityAndAllDigitsAreWritten()
    {
        float[] numbers = [float.PositiveInfinity, -1, float.Epsilon, 12.3456789f];
        var file = Written(new(4, 1), numbers);
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
