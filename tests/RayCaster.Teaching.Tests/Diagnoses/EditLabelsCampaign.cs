namespace RayCaster.Teaching.Tests.Diagnoses;

/// <summary>More of the edits that have a label than the tests take.</summary>
public class EditLabelsCampaign
{
    [Theory(Explicit = true)]
    [InlineData("v-up")]
    [InlineData("no-center")]
    [InlineData("att-zfar")]
    public void ALabelledEditIsDrawnAndNamedAsItsMistake(string id) => EditLabelsTests.LabelledEditsAreDrawnAndNamedAsTheirMistake(id, 3);
}
