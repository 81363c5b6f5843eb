namespace RayCaster.Teaching.Tests.Comparison;

public class PictureDifferenceTests
{
    private static readonly Picture still = SomePictures.Still();

    private static readonly PictureDifference difference = new(
        still.With(picture =>
        {
            picture[50, 3] = (0, 2, 255);
            picture[7, 5] = (10, 1, 0);
            picture[60, 9] = (0, 1, 1);
        }),
        still);

    [Fact]
    public void EqualPicturesDifferNowhere()
    {
        var none = new PictureDifference(SomePictures.Still(), still);
        Assert.Equal((0, 0, 0, null, null), (none.Wrong, none.OffByOne, none.Largest, none.WrongMiddle, none.WrongArea));
    }

    [Fact]
    public void WrongIsWhatDiffersByMoreThanOneLevel() => Assert.Equal((2, 1), (difference.Wrong, difference.OffByOne));

    [Fact]
    public void PixelsAreCountedBeyondAnyNumberOfLevels() =>
        Assert.Equal([3, 2, 2, 1, 1, 0], new[] { 0, 1, 9, 10, 254, 255 }.Select(difference.CountBeyond));

    [Fact]
    public void TheLargestDifferenceIsThatOfAChannel() => Assert.Equal(255, difference.Largest);

    [Fact]
    public void ThePixelToLookAtIsInTheMiddleOfTheWidestWrongArea()
    {
        var mine = still.With(picture =>
        {
            for (var y = 2; y < 6; y++) picture[3, y] = (9, 99, 9); // a line: the outline of something, say
            for (var i = 0; i < 25; i++) picture[20 + i % 5, 10 + i / 5] = (9, 99, 9);
        });
        Assert.Equal((22, 12), new PictureDifference(mine, still).WrongMiddle);
    }

    [Fact]
    public void TheAreaHoldsAllThatIsBeyondRounding() => Assert.Equal((7, 3, 50, 5), difference.WrongArea);

    [Fact]
    public void APixelIsOneDarkerIfNoChannelIsLighter()
    {
        Assert.Equal((0, 0, 0), still[60, 1]);
        var grey = Picture.Create(4, 1, (_, _) => (9, 9, 9));
        var mine = Picture.Create(4, 1, (x, _) => x switch { 0 => (8, 9, 9), 1 => (8, 8, 8), 2 => (8, 10, 9), _ => (9, 9, 10) });
        Assert.Equal((4, 2), (new PictureDifference(mine, grey).OffByOne, new PictureDifference(mine, grey).OneDarker));
    }

    [Fact]
    public void PicturesOfDifferentSizesCannotBeCompared() =>
        Assert.Throws<ArgumentException>(() => new PictureDifference(new Picture(2, 3), new Picture(3, 2)));
}
