using System.Text;

namespace RayCaster.Teaching.Tests.Maps;

public class PfmFileTests
{
    private static readonly string Data = ProjectFolder.PathOf("tests/RayCaster.Teaching.Tests/Maps/Data");

    [Theory]
    [InlineData("grey-little.netpbm.pfm")]
    [InlineData("grey-big.netpbm.pfm")]
    public void AForeignMapIsReadFromTheTopDown(string name)
    {
        var map = PfmFile.Read(Path.Combine(Data, name));
        Assert.Equal((3, 2, 1), (map.Width, map.Height, map.Channels));
        Assert.Equal([0, 0.25f, 0.5f, 0.75f, 1, 0.5f], map.Values);
    }

    [Fact]
    public void AForeignMapOfVectorsIsReadFromTheTopDown()
    {
        var map = PfmFile.Read(Path.Combine(Data, "colours.netpbm.pfm"));
        Assert.Equal((2, 2, 3), (map.Width, map.Height, map.Channels));
        Assert.Equal([0, 0.25f, 0.5f, 0.75f, 1, 0, 1, 0.75f, 0.5f, 0.25f, 0, 1], map.Values);
    }

    [Theory]
    [InlineData("grey-little.netpbm.pfm")]
    [InlineData("colours.netpbm.pfm")]
    public void AMapIsWrittenAsNetpbmWritesIt(string name)
    {
        var foreign = Encoding.Latin1.GetString(File.ReadAllBytes(Path.Combine(Data, name)));
        Assert.Equal(foreign.Replace("-1.000000", "-1.0"), Written(PfmFile.Read(Path.Combine(Data, name))));
    }

    [Fact]
    public void InfinityAndAllDigitsComeBack()
    {
        var map = new NumberMap(2, 2, 1);
        ReadOnlySpan<float> numbers = [float.PositiveInfinity, -1, float.Epsilon, 12.3456789f];
        numbers.CopyTo(map.Values);
        Assert.Equal(map.Values, Read(Written(map)).Values);
    }

    [Theory]
    [InlineData("it begins with 'P6'", "P6\n1 1\n255\n123")]
    [InlineData("its header is cut", "Pf\n1 1\n")]
    [InlineData("one side is '0'", "Pf\n0 1\n-1.0\n")]
    [InlineData("its scale is '0'", "Pf\n1 1\n0\n1234")]
    [InlineData("1 × 2 pixels need 8 bytes, but only 4 follow", "Pf\n1 2\n-1.0\n1234")]
    [InlineData("1000000 × 1000000 pixels need", "PF\n1000000 1000000\n-1.0\n1234")]
    public void WhatIsNoMapIsRefusedInWords(string message, string file) =>
        Assert.Contains(message, Assert.Throws<PictureFileException>(() => Read(file)).Message);

    private static string Written(NumberMap map)
    {
        using var stream = new MemoryStream();
        PfmFile.Write(stream, map);
        return Encoding.Latin1.GetString(stream.ToArray());
    }

    private static NumberMap Read(string file)
    {
        using var stream = new MemoryStream(Encoding.Latin1.GetBytes(file));
        return PfmFile.Read(stream);
    }
}
