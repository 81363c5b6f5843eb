using Xunit.Sdk;

namespace RayCaster.Tests.Scenes;

public sealed class PictureAssertTests : InTemporaryFolder
{
    /// <summary>20 × 10 pixels: grey on the left, red on the right.</summary>
    private static Picture Halves(Action<Picture>? change = null)
    {
        var picture = new Picture(20, 10);
        for (var y = 0; y < 10; y++)
            for (var x = 0; x < 20; x++) picture[x, y] = x < 10 ? ((byte)100, (byte)100, (byte)100) : ((byte)200, (byte)0, (byte)0);
        change?.Invoke(picture);
        return picture;
    }

    private void Keep(Picture picture, Picture? outline = null)
    {
        PictureFile.Write(folder["scene.png"], picture);
        if (outline is not null) PictureFile.Write(folder["scene.outline.png"], outline);
    }

    private string FailureOf(Picture actual) => Assert.Throws<FailException>(() => PictureAssert.Equal("scene", actual, folder.Path)).Message;

    [Fact]
    public void AFailureSaysWhatInItsFirstLineAndLeavesTwoPictures()
    {
        Keep(Halves());
        var lines = FailureOf(Halves(picture => picture[3, 2] = picture[4, 2] = (100, 100, 7))).Split('\n');
        Assert.Equal("scene.png: 2 of 200 pixels (1 %) differ, by at most 93; the first at column 3, line 2 from the top: "
            + "expected (100, 100, 100), got (100, 100, 7)", lines[0]);
        Assert.Equal("  dotnet run --project src/RayCaster.Cli -- explain scenes/scene.json 3 2 --size 20x10", lines[1]);
        Assert.Equal("  " + folder["scene.received.png"], lines[2]);
        Assert.Equal("  " + folder["scene.diff.png"], lines[3]);
        Assert.Equal(["scene.diff.png", "scene.png", "scene.received.png"], folder.Names);
        Assert.Equal((255, 0, 0), PictureFile.Read(folder["scene.diff.png"])[3, 2]);
        Assert.Equal((100, 100, 7), PictureFile.Read(folder["scene.received.png"])[3, 2]);
    }

    [Fact]
    public void OnePixelInAHundredMayBeOffByOneAndNoMore()
    {
        Keep(Halves());
        FailureOf(new Picture(10, 20));
        Assert.StartsWith("scene.png: 3 of 200 pixels (1.5 %) are off by 1; at most 1 % may be\n",
            FailureOf(Halves(picture => picture[3, 2] = picture[4, 2] = picture[5, 2] = (100, 101, 100))));
        PictureAssert.Equal("scene", Halves(picture => picture[3, 2] = picture[4, 2] = (100, 101, 99)), folder.Path);
        Assert.Equal(["scene.png"], folder.Names); // the pictures of the last failure are gone
    }

    [Theory]
    [InlineData(10, 100, 100, true)] // the left neighbour's colour
    [InlineData(10, 200, 0, true)]   // the right one's
    [InlineData(10, 90, 0, false)]   // neither
    [InlineData(10, 150, 50, false)] // each channel is between theirs
    [InlineData(10, 200, 100, false)] // each channel is of one of them
    [InlineData(11, 100, 100, false)] // not on the outline
    public void OnAnOutlineAPixelMayShowEitherNeighbour(int x, byte red, byte green, bool passes)
    {
        var outline = new Picture(20, 10);
        outline[10, 5] = (255, 255, 255);
        Keep(Halves(), outline);
        var actual = Halves(picture => picture[x, 5] = (red, green, green));
        if (passes) PictureAssert.Equal("scene", actual, folder.Path);
        else Assert.Contains($"the first at column {x}, line 5 from the top", FailureOf(actual));
    }
}
