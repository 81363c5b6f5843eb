namespace RayCaster.Teaching.Tests.Comparison;

public class PictureJudgeTests
{
    private static readonly Picture still = SomePictures.Still(); // 6144 pixels

    private static Likeness VerdictOn(Action<Picture> change) => new PictureComparison(still.With(change), still).Likeness;

    private static void MakeLighter(Picture picture, int pixels)
    {
        for (var x = 0; x < pixels; x++) picture[x, 0] = (1, 0, 0);
    }

    [Fact]
    public void EqualPicturesAreIdentical() => Assert.Equal(Likeness.Identical, VerdictOn(_ => { }));

    [Fact]
    public void OnePixelInAHundredMayBeOffByOne() => Assert.Equal(Likeness.WithinRounding, VerdictOn(picture => MakeLighter(picture, 61)));

    [Fact]
    public void MoreThanThatIsRoundedOtherwise() => Assert.Equal(Likeness.RoundedOtherwise, VerdictOn(picture => MakeLighter(picture, 62)));

    [Fact]
    public void APixelOnAnOutlineMayShowItsNeighbour() =>
        Assert.Equal(Likeness.OutlinesOnly, VerdictOn(picture => picture[10, 40] = picture[9, 40])); // the box begins at column 10

    [Fact]
    public void ButNotWhatNoNeighbourShows() => Assert.Equal(Likeness.Wrong, VerdictOn(picture => picture[10, 40] = (200, 0, 0)));

    [Fact]
    public void NorWherePixelsBesideItAreLikeIt() => // scattered over the shaded ground
        Assert.Equal(Likeness.Wrong, VerdictOn(picture =>
        {
            for (var x = 2; x < 90; x += 5) picture[x, 60] = ((byte)(picture[x, 60].R + 2), picture[x, 60].G, picture[x, 60].B);
        }));

    [Fact]
    public void NorInABlockOfFour() => Assert.Equal(Likeness.Wrong, VerdictOn(picture =>
    {
        for (var i = 0; i < 4; i++) picture[10 + i % 2, 40 + i / 2] = picture[9, 40];
    }));

    [Fact]
    public void NorAlongHalfOfTheOutlines() =>
        Assert.Equal(Likeness.Wrong, new PictureComparison(Picture.Create(96, 64, (x, y) => still[Math.Max(0, x - 1), y]), still).Likeness);

    [Theory]
    [InlineData(0, 1, 0, 0, "its first line")]
    [InlineData(0, 0, 1, 0, "its last column")]
    [InlineData(1, 0, 0, 2, "its last 2 lines and its first column")]
    [InlineData(3, 16, 4, 0, "its first 16 lines and its first 3 columns and its last 4 columns")]
    public void ACroppedPictureIsRightButForThat(int left, int top, int right, int bottom, string missing)
    {
        var cropped = Picture.Create(96 - left - right, 64 - top - bottom, (x, y) => still[x + left, y + top]);
        var comparison = new PictureComparison(cropped, still);
        Assert.Equal(Likeness.Wrong, comparison.Likeness);
        Assert.EndsWith($"It is the right picture without {missing}. Was it cropped on its way, for example by a screenshot?\n",
            ComparisonText.Format(comparison, "mine.png", "right.png"));
    }

    [Fact]
    public void ASmallerPictureThatIsWrongIsNotCalledCropped() =>
        Assert.Null(new PictureComparison(SomePictures.Still(96, 63), still).Crop); // the same scene at another size

    [Fact]
    public void PicturesOfDifferentSizesAreWrong() =>
        Assert.Equal(Likeness.Wrong, new PictureComparison(SomePictures.Still(64, 96), still).Likeness);

    [Theory]
    [InlineData(Likeness.Identical, true)]
    [InlineData(Likeness.WithinRounding, true)]
    [InlineData(Likeness.OutlinesOnly, true)]
    [InlineData(Likeness.RoundedOtherwise, false)]
    [InlineData(Likeness.Wrong, false)]
    public void WhatRoundingExplainsIsTheSame(Likeness verdict, bool same) => Assert.Equal(same, verdict.IsSame());
}
