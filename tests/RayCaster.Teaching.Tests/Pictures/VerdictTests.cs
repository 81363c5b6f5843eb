namespace RayCaster.Teaching.Tests.Pictures;

public class VerdictTests
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
        Assert.Equal(Likeness.Wrong, new PictureComparison(Picture.Of(96, 64, (x, y) => still[Math.Max(0, x - 1), y]), still).Likeness);

    [Fact]
    public void PicturesOfDifferentSizesAreWrong() =>
        Assert.Equal(Likeness.Wrong, new PictureComparison(SomePictures.Still(64, 96), still).Likeness);

    [Theory]
    [InlineData("src/RayCaster has been changed.")]
    [InlineData(null)]
    public void AWarningIsInTheJsonOnlyIfThereIsOne(string? warning) => Assert.Equal(
        warning is not null, ComparisonJson.Of(new(still, still), "mine.png", "right.png", warning).Contains($"\"warning\": \"{warning}\""));

    [Theory]
    [InlineData(Likeness.Identical, true)]
    [InlineData(Likeness.WithinRounding, true)]
    [InlineData(Likeness.OutlinesOnly, true)]
    [InlineData(Likeness.RoundedOtherwise, false)]
    [InlineData(Likeness.Wrong, false)]
    public void WhatRoundingExplainsIsTheSame(Likeness verdict, bool same) => Assert.Equal(same, verdict.IsSame());
}
