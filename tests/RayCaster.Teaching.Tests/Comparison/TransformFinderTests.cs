namespace RayCaster.Teaching.Tests.Comparison;

/// <summary>What was done to a whole picture is found, and nothing is claimed that is not so.</summary>
public class TransformFinderTests
{
    private static readonly Picture still = SomePictures.Still();
    private static readonly Picture square = SomePictures.Still(64, 64);

    private static Recognition? Recognise(Picture mine, Picture reference) => new PictureComparison(mine, reference).Recognition;

    /// <summary>What must be done to the picture is the opposite of what was done.</summary>
    private static void Recognises(PictureTransform transform, Picture mine, Picture reference)
    {
        var recognition = Recognise(mine, reference);
        Assert.Equal(transform, recognition?.Transform);
        Assert.Equal(Likeness.Identical, recognition!.Likeness);
    }

    /// <summary>Where a pixel of the turned picture comes from in one of 96 x 64 pixels.</summary>
    private static (int X, int Y) Source(Turn turn, int x, int y) => turn switch
    {
        Turn.TopBottom => (x, 63 - y),
        Turn.LeftRight => (95 - x, y),
        Turn.Half => (95 - x, 63 - y),
        Turn.Transposed => (y, x),
        Turn.Clockwise => (95 - y, x), // it was turned counter-clockwise: its first column, from the bottom, is the reference's first line
        Turn.CounterClockwise => (y, 63 - x),
        _ => (95 - y, 63 - x),
    };

    [Theory]
    [InlineData(1)]
    [InlineData(2, Explicit = true)]
    [InlineData(3)]
    [InlineData(4)]
    [InlineData(5, Explicit = true)]
    [InlineData(6, Explicit = true)]
    [InlineData(7)]
    public void EachTurn(int number)
    {
        var turn = (Turn)number;
        var (width, height) = turn >= Turn.Transposed ? (64, 96) : (96, 64);
        Recognises(new(turn), Picture.Create(width, height, (x, y) => Source(turn, x, y) is var (u, v) ? still[u, v] : default), still);
    }

    [Fact]
    public void TransposedInASquare() => Recognises(new(Turn.Transposed), Picture.Create(64, 64, (x, y) => square[y, x]), square);

    [Fact]
    public void ChannelsInAnotherOrder()
    {
        Recognises(new(Channels: "BGR"), still.Map(p => (p.B, p.G, p.R)), still);
        Recognises(new(Channels: "GBR"), still.Map(p => (p.G, p.B, p.R)), still);
    }

    [Fact]
    public void SidesSwappedInTheHeader()
    {
        var mine = new Picture(64, 96);
        still.Rgb.CopyTo(mine.Rgb, 0);
        Recognises(new(SidesSwapped: true), mine, still);
    }

    [Theory]
    [InlineData(1, 0)]
    [InlineData(0, -1, Explicit = true)]
    [InlineData(-7, 5)]
    [InlineData(16, -16, Explicit = true)]
    public void Moved(int right, int down) => Recognises(
        new(Turn.None, right, down),
        Picture.Create(96, 64, (x, y) => x + right is >= 0 and < 96 && y + down is >= 0 and < 64 ? still[x + right, y + down] : default),
        still);

    [Fact]
    public void FlippedAndOneLineOff() => // V points down: row r shows −ur, so line 0 has no counterpart
        Recognises(
            new(Turn.TopBottom, Down: 1), Picture.Create(96, 64, (x, y) => y == 0 ? default : still[x, 64 - y]), still.With(p =>
        {
            for (var x = 0; x < 96; x++) p[x, 0] = (50, 60, 70);
        }));

    [Theory]
    [InlineData(1)]
    [InlineData(-1, Explicit = true)]
    [InlineData(2, Explicit = true)]
    public void MovedByBytes(int bytes)
    {
        var mine = new Picture(96, 64);
        for (var i = 0; i < mine.Rgb.Length; i++)
            if (i + bytes >= 0 && i + bytes < mine.Rgb.Length) mine.Rgb[i] = still.Rgb[i + bytes];
        Recognises(new(Bytes: bytes), mine, still);
    }

    [Fact]
    public void ATruncatedFlippedPictureBecomesRightButForRounding()
    {
        var mine = Picture.Create(96, 64, (x, y) => still[x, 63 - y]).Map(p => ((byte)Math.Max(0, p.R - 1), p.G, p.B));
        var recognition = Recognise(mine, still)!;
        Assert.Equal((new PictureTransform(Turn.TopBottom), Likeness.RoundedOtherwise), (recognition.Transform, recognition.Likeness));
    }

    [Fact]
    public void WhatIsLeftWrongIsTold()
    {
        var mine = Picture.Create(96, 64, (x, y) => still[x, 63 - y]).With(p => p[3, 3] = p[4, 4] = (9, 9, 9));
        var recognition = Recognise(mine, still)!;
        Assert.Equal((new PictureTransform(Turn.TopBottom), Likeness.Wrong, 2),
            (recognition.Transform, recognition.Likeness, recognition.Difference.Wrong));
    }

    [Fact]
    public void NothingIsClaimedOfAMissingBall() =>
        Assert.Null(Recognise(still.Map(p => p.B == 20 ? ((byte)0, (byte)0, (byte)0) : p), still));

    [Fact]
    public void NothingIsClaimedOfAnUnrelatedPicture() =>
        Assert.Null(Recognise(Picture.Create(96, 64, (x, y) => ((byte)(x * y), (byte)(x ^ y), (byte)(3 * y))), still));

    [Fact]
    public void NothingIsClaimedOfABlackPicture() => Assert.Null(Recognise(new Picture(96, 64), still));
}
