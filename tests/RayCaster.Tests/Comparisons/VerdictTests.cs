namespace RayCaster.Tests.Comparisons;

public class VerdictTests
{
    private static readonly Picture still = SomePictures.Still(); // 6144 pixels

    private static Verdict VerdictOn(Action<Picture> change) => new PictureComparison(still.With(change), still).Verdict;

    private static void MakeLighter(Picture picture, int pixels)
    {
        for (var x = 0; x < pixels; x++) picture[x, 0] = (1, 0, 0);
    }

    [Fact]
    public void EqualPicturesAreIdentical() => Assert.Equal(Verdict.Identical, VerdictOn(_ => { }));

    [Fact]
    public void OnePixelInAHundredMayBeOffByOne() => Assert.Equal(Verdict.WithinRounding, VerdictOn(picture => MakeLighter(picture, 61)));

    [Fact]
    public void MoreThanThatIsRoundedOtherwise() => Assert.Equal(Verdict.RoundedOtherwise, VerdictOn(picture => MakeLighter(picture, 62)));

    [Fact]
    public void APixelOnAnOutlineMayShowItsNeighbour() =>
        Assert.Equal(Verdict.OutlinesOnly, VerdictOn(picture => picture[10, 40] = picture[9, 40])); // the box begins at column 10

    [Fact]
    public void ButNotWhatNoNeighbourShows() => Assert.Equal(Verdict.Wrong, VerdictOn(picture => picture[10, 40] = (200, 0, 0)));

    [Fact]
    public void NorInABlockOfFour() => Assert.Equal(Verdict.Wrong, VerdictOn(picture =>
    {
        for (var i = 0; i < 4; i++) picture[10 + i % 2, 40 + i / 2] = picture[9, 40];
    }));

    [Fact]
    public void NorAlongHalfOfTheOutlines() =>
        Assert.Equal(Verdict.Wrong, new PictureComparison(SomePictures.Make(96, 64, (x, y) => still[Math.Max(0, x - 1), y]), still).Verdict);

    [Fact]
    public void PicturesOfDifferentSizesAreWrong() =>
        Assert.Equal(Verdict.Wrong, new PictureComparison(SomePictures.Still(64, 96), still).Verdict);

    [Theory]
    [InlineData(Verdict.Identical, true)]
    [InlineData(Verdict.WithinRounding, true)]
    [InlineData(Verdict.OutlinesOnly, true)]
    [InlineData(Verdict.RoundedOtherwise, false)]
    [InlineData(Verdict.Wrong, false)]
    public void WhatRoundingExplainsIsTheSame(Verdict verdict, bool same) => Assert.Equal(same, verdict.IsSame());
}
