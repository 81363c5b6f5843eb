namespace RayCaster.Teaching.Tests.Diagnoses;

/// <summary>All edits, where the tests take each eighth.</summary>
public class LabCampaign
{
    [Fact]
    public void AnEditReadsOnlyWhatALabKnows() => LabTests.EditsReadOnlyWhatALabKnows(1);
}
