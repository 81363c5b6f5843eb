using RayCaster.Teaching.Tests.Mistakes;
using Planted = RayCaster.Teaching.Tests.Mistakes.Mistake;

namespace RayCaster.Teaching.Tests.Comparisons;

/// <summary>Mistakes that run through a whole picture, planted in the ray caster of the tests, are recognised from the picture.</summary>
public class MistakesComparedTests
{
    [Theory]
    [InlineData("rows", "It becomes identical when it is flipped top to bottom.")]
    [InlineData("v-cross", "when it is flipped top to bottom and it is moved 1 line up.")]
    [InlineData("cols", "It becomes identical when it is mirrored left to right.")]
    [InlineData("u-only", "when it is mirrored left to right and it is moved 1 pixel to the right.")]
    [InlineData("u-cross", "when it is turned by 180° and it is moved 1 pixel to the right and 1 line up.")]
    [InlineData("bgr", "It becomes identical when red and blue are swapped.")]
    [InlineData("gamma", "when gamma is undone: it shows c^0.5 instead of c (gamma 2;")]
    [InlineData("whswap", "when its width and height are swapped and its bytes left as they are")]
    [InlineData("crlf", "when all bytes are moved by 1 towards the beginning")]
    [InlineData("round", "one level darker: truncated instead of rounded?")]
    [InlineData("pix-int", "Every pixel of")]
    public void AreRecognised(string mistake, string text)
    {
        var scene = SceneFolder.Small("mistakes/generic");
        var comparison = new PictureComparison(EditedLab.Render(scene, Planted.Named(mistake)), Renderer.Render(scene), scene);
        Assert.Contains(text, ComparisonText.Of(comparison, "mine.png", "reference.png"));
    }
}
