namespace RayCaster.Teaching.Tests.Diagnoses;

/// <summary>The further wordings of Mistakes.txt: each names a mistake of the catalogue, and edits have it.</summary>
public class EditLabelsTests
{
    private static readonly FormulaEdit[] edits =
        [.. Enum.GetValues<SectionKind>().SelectMany(FormulaBook.Slides.StylesOf).SelectMany(EditFactory.EditsOf)];

    [Fact]
    public void EachLabelIsAnIdOfTheCatalogue() =>
        Assert.All(edits.Select(edit => edit.Label).OfType<string>().Distinct(), id => Assert.NotNull(MistakeCatalog.Named(id)));

    [Fact]
    public void EachPatternFitsAnEdit() => Assert.All(MistakeBook.Labels.Where(label => label.Step is not null),
        label => Assert.Contains(edits, edit => edit.Section.Kind == label.Step!.Kind && EditLabels.Fits(edit, label)));

    [Theory]
    [InlineData("camera", "V = up × U", "v-up")] // written out
    [InlineData("camera", "h = tan(angle / 2)", "no2")]
    [InlineData("sphere geometric", "t_hc = √(R − D2)", "r-nosq")] // by a pattern
    [InlineData("sphere abc", "D = b² − 2·a·c", "disc-2")]
    [InlineData("triangle determinants", "hit if u ≥ 0 and v ≥ 0", "tri-uv")]
    [InlineData("light", "att = max(0, 1 − t / (4·|T − P|))", "att-no2")]
    [InlineData("sphere geometric", "t_hc = √(2·R² − D2)", null)]
    public void AnEditHasThisLabel(string section, string formula, string? id) =>
        Assert.Equal(id, edits.First(edit => edit.Section.Name == section && edit.Section.Formulas.Any(own => own.ToString() == formula)).Label);

    [Theory]
    [InlineData("v-up")]
    [InlineData("att-zfar")]
    public void ALabelledEditIsDrawnAndNamedAsItsMistake(string id) => LabelledEditsAreDrawnAndNamedAsTheirMistake(id, 1);

    internal static void LabelledEditsAreDrawnAndNamedAsTheirMistake(string id, int count)
    {
        var scene = DiagnosisTests.scene;
        foreach (var edit in edits.Where(edit => edit.Label == id && edit.Operator == EditOperator.OtherLaw && edit.Place is not null).Take(count))
        {
            var mistake = EditNaming.Of([edit]);
            Assert.Equal(id, mistake.Id);
            var suspect = Diagnosis.Of(scene, MistakeCatalog.Draw(scene, [mistake])).Suspects[0];
            Assert.Contains(id, suspect.Mistakes.Concat(suspect.Twins).Select(named => named.Id));
        }
    }
}
