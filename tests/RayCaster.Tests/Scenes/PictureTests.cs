namespace RayCaster.Tests.Scenes;

public class PictureTests
{
    [Theory]
    [InlineData(-1, 1)]
    [InlineData(3, 0)]
    [InlineData(0, -1)]
    [InlineData(0, 2)]
    public void APixelOutsideThrows(int x, int y)
    {
        var picture = new Picture(3, 2);
        Assert.Throws<ArgumentOutOfRangeException>(() => picture[x, y]);
        Assert.Throws<ArgumentOutOfRangeException>(() => picture[x, y] = default);
    }

    [Fact]
    public void ABufferOfAnotherSizeThrows() => Assert.Throws<ArgumentException>(() => new Picture(3, 2, new byte[17]));
}
