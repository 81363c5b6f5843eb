namespace RayCaster.Teaching.Tests.Hypotheses;

public class HypothesisSearchTests
{
    [Fact] // three explain any picture by chance
    public void NoExplanationHasThreeMistakes()
    {
        var scene = SceneFolder.Small("first", 20);
        var picture = ProgramInWords.Draw(scene, "formulas rows & formulas bgr & formulas att-no2 & formulas far-root");
        var hypotheses = new HypothesisSearch(
            [new PictureSample(scene, Renderer.Render(scene), picture, 6000)], MistakeCatalog.All, [], null, null, null, null).Run();
        Assert.All(hypotheses, of => Assert.InRange(of.Mistakes.Count, 0, 2));
    }
}
