namespace RayCaster.Teaching.Tests.Diagnoses;

/// <summary>All edits, where the tests take each eighth.</summary>
public class FormulaProgramCampaign
{
    [Fact(Explicit = true)]
    public void AnEditReadsOnlyWhatAProgramComputes() => FormulaProgramTests.EditsReadOnlyWhatAProgramComputes(1);
}
