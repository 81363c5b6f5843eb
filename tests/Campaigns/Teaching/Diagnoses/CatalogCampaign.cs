using RayCaster.Teaching.Tests.Mistakes;
using static RayCaster.Teaching.Tests.Diagnoses.CatalogTests;
using Planted = RayCaster.Teaching.Tests.Mistakes.Mistake;

namespace RayCaster.Teaching.Tests.Diagnoses;

/// <summary>The catalogue, against the lab, whose source is edited to have the same mistakes.</summary>
public class CatalogCampaign
{
    [Theory]
    [MemberData(nameof(Ids), MemberType = typeof(CatalogTests))]
    public void OneWordingDrawsWhatTheLabWithThatMistakeDraws(string id)
    {
        var expected = scenes.Values.Select(scene => (Scene: scene, Picture: EditedLab.Render(scene, Planted.Named(id)))).ToArray();
        var mistake = MistakeCatalog.Named(id)!;
        IEnumerable<RayCaster.Teaching.Mistake> InManners(RayCaster.Teaching.Mistake wording) => mistake.InManners(wording).Prepend(wording);
        Assert.Contains(mistake.Wordings.SelectMany(InManners).SelectMany(InManners),
            wording => expected.All(one => IsDrawnBy(one.Picture, MistakeCatalog.Draw(one.Scene, [wording]))));
    }
}
