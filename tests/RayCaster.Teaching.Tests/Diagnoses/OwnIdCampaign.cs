namespace RayCaster.Teaching.Tests.Diagnoses;

/// <summary>Slips that once had the name of another, whose question misled: planted in the lab's source.</summary>
public class OwnIdCampaign
{
    [Theory(Explicit = true)]
    [InlineData("slab-axis", "aabb", "Aabb", "Slab(B0.Z, B1.Z, P.Z, d.Z)", "Slab(B0.Z, B1.Z, P.Y, d.Z)")]
    public void AnotherSlipHasItsOwnId(string id, string name, string file, string old, string @new) =>
        new OwnIdTests().ASlipHasItsOwnId(id, name, file, old, @new);
}
