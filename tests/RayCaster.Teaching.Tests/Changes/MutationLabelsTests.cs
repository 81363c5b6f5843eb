namespace RayCaster.Teaching.Tests.Changes;

/// <summary>The further wordings of Mistakes.txt: each names a mistake of the catalogue, and edits have it.</summary>
public class MutationLabelsTests
{
    private static readonly Mutation[] edits =
        [.. Enum.GetValues<StepKind>().SelectMany(FormulaBook.Slides.StylesOf).SelectMany(MutationFactory.MutationsOf)];

    [Fact]
    public void EachLabelIsAnIdOfTheCatalogue() =>
        Assert.All(edits.Select(edit => edit.Label).OfType<string>().Distinct(), id => Assert.NotNull(MistakeCatalog.Named(id)));

    [Fact]
    public void EachPatternFitsAnEdit() => Assert.All(MistakeBook.Labels.Where(label => label.Step is not null),
        label => Assert.Contains(edits, edit => edit.Step.Kind == label.Step!.Kind && MutationLabels.Fits(edit, label)));

    [Theory]
    [InlineData("att-zfar", 1)]
    [InlineData("v-up", 3, Explicit = true)]
    [InlineData("no-center", 3, Explicit = true)]
    [InlineData("att-zfar", 3, Explicit = true)]
    public void LabelledEditsAreDrawnAndNamedAsTheirMistake(string id, int count)
    {
        var scene = DiagnosisTests.scene;
        foreach (var edit in edits
            .Where(edit => edit.Label == id && edit.Operator == MutationBook.Slips["OtherLaw"] && edit.Place is not null).Take(count))
        {
            var mistake = MutationNaming.Named([ChangeSource.From(edit)]);
            Assert.Equal(id, mistake.Id);
            var suspect = DiagnosisResult.Find(scene, MistakeCatalog.Draw(scene, [mistake]), new()).Suspects[0];
            Assert.Contains(id, DiagnosisTests.Named(suspect));
        }
    }
}
