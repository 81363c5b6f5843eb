namespace RayCaster.Teaching.Tests.Diagnoses;

/// <summary>The shortest explanation comes first, and its bits are those of its changes if it leaves nothing.</summary>
public class ExplanationSearchTests
{
    private static readonly Scene generic = SceneFolder.Small("mistakes/generic", 2), room = SceneFolder.Small("room", 4);

    [Theory]
    [InlineData("r-nosq", Priors.Known)]
    [InlineData("v-cross", Priors.Known + Priors.Rare)]
    [InlineData("center", Priors.OtherSample)]
    [InlineData("circ-inf slab-tmax", 2 * Priors.Known)]
    public void AnExactExplanationCostsWhatItsChangesCost(string ids, double bits)
    {
        var best = Search([generic], ids)[0];
        Assert.Equal(ids, best.Id);
        Assert.Equal(bits, best.Total);
    }

    [Fact]
    public void WhatIsNotWrittenYetIsAChange()
    {
        var best = Search([generic with { Models = [.. generic.Models.Where(model => model.Kind != "circle")] }], "r-nosq", of: generic)[0];
        Assert.Equal("circle r-nosq", best.Id);
        Assert.Equal(Priors.Known + Priors.NotYet, best.Total);
    }

    [Fact]
    public void SeveralPicturesAreOneSum()
    {
        var best = Search([generic, room], "oc-sign")[0];
        Assert.Equal(("oc-sign", Priors.Known), (best.Id, best.Total));
    }

    [Fact]
    public void NoExplanationHasThreeMistakes() =>
        Assert.All(Search([generic], "rows bgr att-no2 slab-tmax"), program => Assert.InRange(program.Variants.Count, 0, 2));

    /// <param name="of">The scene that the picture should show; the one that it shows if null.</param>
    private static List<WrongProgram> Search(Scene[] scenes, string ids, Scene? of = null)
    {
        Mistake[] mistakes = [.. ids.Split(' ').Select(id => MistakeCatalog.Named(id)!)];
        var pictures = scenes.Select(scene => new Evidence(of ?? scene, Renderer.Render(of ?? scene), MistakeCatalog.Draw(scene, mistakes), 6000));
        return new ExplanationSearch([.. pictures], MistakeCatalog.All, [], null, null, null, null).Run();
    }
}
