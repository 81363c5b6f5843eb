namespace RayCaster.Teaching.Tests.Explanations;

/// <summary>More random scenes than the tests take.</summary>
public class DerivationCampaign
{
    [Fact(Explicit = true)]
    public void EveryFormulaGivesTheSameBitsAsPlainDoubles() => DerivationTests.FormulasGiveTheSameBitsAsPlainDoubles(300);
}
