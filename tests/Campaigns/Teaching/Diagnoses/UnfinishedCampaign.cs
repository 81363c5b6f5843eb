using RayCaster.Teaching.Tests.Mistakes;

namespace RayCaster.Teaching.Tests.Diagnoses;

/// <summary>Programs that do not draw everything yet: the pictures are <see cref="EditedLab"/>'s, of scenes from which models were
/// taken.</summary>
public class UnfinishedCampaign
{
    [Theory]
    [InlineData("circle,triangle")]
    [InlineData("aabb,circle,triangle")]
    [InlineData("plane")]
    public void WhatElseIsNotDrawnYetIsSaid(string kinds) => new UnfinishedTests().WhatIsNotDrawnYetIsSaidAndNothingElse(kinds);

    [Theory]
    [InlineData("aabb", "nohalf")]
    [InlineData("sphere,triangle", "bgr")]
    public void OtherMistakesOnTopAreNamed(string kinds, string id) => new UnfinishedTests().AMistakeOnTopOfWhatIsThereIsNamed(kinds, id);
}
