namespace RayCaster.Teaching.Tests.Comparison;

public class SideBySideTests
{
    private static double Lightness((byte R, byte G, byte B) color)
    {
        static double Linear(byte channel) =>
            channel / 255.0 <= 0.04045 ? channel / 255.0 / 12.92 : Math.Pow((channel / 255.0 + 0.055) / 1.055, 2.4);
        return 0.2126 * Linear(color.R) + 0.7152 * Linear(color.G) + 0.0722 * Linear(color.B);
    }

    [Fact]
    public void TheMoreLevelsTheLighter() =>
        Assert.All(Enumerable.Range(1, 255), levels => Assert.True(Lightness(HeatMap.ColorOf(levels)) >= Lightness(HeatMap.ColorOf(levels - 1))));

    [Fact]
    public void NoDifferenceIsBlackAndOneLevelIsSeen()
    {
        Assert.Equal((0, 0, 0), HeatMap.ColorOf(0));
        Assert.True(Lightness(HeatMap.ColorOf(1)) > 0.01);
    }

    [Fact]
    public void MineIsLeftTheReferenceInTheMiddleAndTheHeatRight()
    {
        var reference = SomePictures.Still(8, 4);
        var mine = reference.With(picture => picture[7, 3] = (255, 255, 255));
        var picture = SideBySide.Draw(new PictureComparison(mine, reference));
        Assert.Equal((8 + 2 + 8 + 2 + 8, 4), (picture.Width, picture.Height));
        Assert.Equal((255, 255, 255), picture[7, 3]);
        Assert.Equal((128, 128, 128), picture[8, 3]);
        Assert.Equal(reference[7, 3], picture[10 + 7, 3]);
        Assert.Equal(HeatMap.ColorOf(255 - Math.Min(reference[7, 3].R, Math.Min(reference[7, 3].G, reference[7, 3].B))), picture[20 + 7, 3]);
        Assert.Equal((0, 0, 0), picture[20, 0]);
    }

    [Fact]
    public void PicturesOfDifferentSizesHaveNoHeatMap()
    {
        var picture = SideBySide.Draw(new PictureComparison(SomePictures.Still(8, 4), SomePictures.Still(5, 9)));
        Assert.Equal((8 + 2 + 5, 9), (picture.Width, picture.Height));
        Assert.Equal((128, 128, 128), picture[0, 4]);
    }
}
