namespace RayCaster.Teaching.Tests.Formulas;

/// <summary>Other slips that the catalogue does not have: the diagnosis says in which formula they are.</summary>
public class NamedSlipsCampaign
{
    [Theory(Explicit = true)]
    [InlineData("C − B for C − A", "triangle", "e2", "e2 = C − A")]
    [InlineData("uc = w c / width − w / 4", "pixel", "uc", "uc = w·c / width − w / 2")]
    public void AnotherSlipIsFoundInItsFormula(string what, string section, string step, string formula) =>
        new PlantedSlipsTests().ASlipIsFoundInItsFormula(what, section, step, formula);
}
