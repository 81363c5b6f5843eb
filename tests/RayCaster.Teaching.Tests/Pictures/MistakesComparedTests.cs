using RayCaster.Teaching.Tests.Mistakes;
using Planted = RayCaster.Teaching.Tests.Mistakes.Mistake;

namespace RayCaster.Teaching.Tests.Pictures;

/// <summary>Mistakes that run through a whole picture, planted in the ray caster of the tests, are recognised from the picture.</summary>
public class MistakesComparedTests
{
    [Theory]
    [InlineData("rows", "Flipped top to bottom it is right: are rows written upside down?")]
    [InlineData("v-cross", "Flipped top to bottom and moved 1 line up it is right")]
    [InlineData("cols", "Mirrored left to right it is right: are columns written from the right?")]
    [InlineData("u-only", "Mirrored left to right and moved 1 pixel to the right it is right")]
    [InlineData("u-cross", "Turned by 180° and moved 1 pixel to the right and moved 1 line up it is right")]
    [InlineData("bgr", "Read as BGR it is right: are red, green and blue written in another order?")]
    [InlineData("whswap", "With width and height swapped in its header it is right")]
    [InlineData("crlf", "With its bytes moved by 1 towards the beginning it is right")]
    [InlineData("round", "one level darker: truncated instead of rounded?")]
    [InlineData("pix-int", "Every pixel of")]
    public void AreRecognised(string mistake, string text)
    {
        var scene = SceneFolder.Small("mistakes/generic");
        var comparison = new PictureComparison(EditedLab.Render(scene, Planted.Named(mistake)), Renderer.Render(scene), scene);
        Assert.Contains(text, ComparisonText.Of(comparison, "mine.png", "reference.png"));
    }
}
