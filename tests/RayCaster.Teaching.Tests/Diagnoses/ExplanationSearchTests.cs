namespace RayCaster.Teaching.Tests.Diagnoses;

public class ExplanationSearchTests
{
    [Fact] // three explain any picture by chance
    public void NoExplanationHasThreeMistakes()
    {
        var scene = SceneFolder.Small("first", 20);
        var picture = ProgramInWords.Draw(scene, "formulas rows & formulas bgr & formulas att-no2 & formulas far-root");
        var explanations = new ExplanationSearch(
            [new Evidence(scene, Renderer.Render(scene), picture, 6000)], MistakeCatalog.All, [], null, null, null, null).Run();
        Assert.All(explanations, program => Assert.InRange(program.Variants.Count, 0, 2));
    }
}
