namespace RayCaster.Cli.Tests;

public class BlankPictureTests
{
    [Theory]
    [InlineData(true, new byte[] { 7, 8, 9, 7, 8, 9 }, new byte[] { 7, 8, 9 })]
    [InlineData(true, new byte[] { 1, 2, 3, 0, 0, 0 }, new byte[] { 1, 2, 3 })]
    [InlineData(false, new byte[] { 7, 8, 9, 7, 8, 9 }, new byte[] { 7, 8, 10 })]
    [InlineData(false, new byte[] { 7, 8, 9, 7, 9, 9 }, new byte[] { 7, 8, 9 })]
    [InlineData(false, new byte[] { 1, 2, 3, 0, 0, 0 }, new byte[] { 1, 2, 4 })]
    public void APictureIsBlankIfItIsOfOneColourOrOnlyBackgroundAndBlack(bool isBlank, byte[] first, byte[] second)
    {
        var picture = new BlankPicture(new Color(1 / 255.0, 2 / 255.0, 3 / 255.0));
        picture.Take(first);
        picture.Take(second);
        Assert.Equal(isBlank, picture.IsBlank);
    }
}
