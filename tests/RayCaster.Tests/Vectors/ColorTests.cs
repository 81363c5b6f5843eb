namespace RayCaster.Tests.Vectors;

public class ColorTests
{
    [Theory]
    [InlineData(0, 0)]
    [InlineData(0.49, 0)]
    [InlineData(0.5, 1)]
    [InlineData(127.49, 127)]
    [InlineData(127.5, 128)]
    [InlineData(254.49, 254)]
    [InlineData(254.5, 255)]
    [InlineData(255, 255)]
    public void AChannelIsRoundedToTheNearestByte(double of255, byte expected) =>
        Assert.Equal((expected, expected, expected), new Color(of255 / 255, of255 / 255, of255 / 255).ToBytes());

    [Fact]
    public void EveryByteComesBack()
    {
        for (var b = 0; b <= 255; b++) Assert.Equal((b, 0, 0), new Color(b / 255.0, 0, 0).ToBytes());
    }

    [Theory]
    [InlineData(1.0001)]
    [InlineData(2)]
    [InlineData(1e300)]
    public void MoreThanFullIntensityIsClamped(double channel) => Assert.Equal((255, 0, 255), new Color(channel, 0, channel).ToBytes());

    [Fact]
    public void TheChannelsAreRedGreenBlue() => Assert.Equal((255, 128, 0), new Color(1, 0.5, 0).ToBytes());
}
