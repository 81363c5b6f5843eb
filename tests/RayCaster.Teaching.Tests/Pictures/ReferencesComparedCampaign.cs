namespace RayCaster.Teaching.Tests.Pictures;

/// <summary>All references, of which <see cref="ReferencesComparedTests"/> compares some.</summary>
public class ReferencesComparedCampaign
{
    public static TheoryData<string> Names => [.. Reference.Names];

    [Theory(Explicit = true)]
    [MemberData(nameof(Names))]
    public void EachPictureThatPovRayDrawsIsTheSame(string name) => new ReferencesComparedTests().ThePictureThatPovRayDrawsIsTheSame(name);
}
