namespace RayCaster.Teaching.Tests.Diagnoses;

public class SceneFitnessCampaign
{
    [Fact(Explicit = true)]
    public void TheProjectsSetOfTestScenesHidesNothing()
    {
        var fitness = SceneFitness.Of([.. SceneFolder.Files("scenes/mistakes").Select(file => SceneFolder.Small(SceneFolder.NameOf(file)))]);
        Assert.Equal(["round", "x256"], fitness.Hidden.Select(mistake => mistake.Id).Order()); // a level at most, by their nature
        Assert.Equal(fitness.Hidden, fitness.WithinRounding);
        Assert.Empty(fitness.Twins);
    }
}
