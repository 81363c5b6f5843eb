namespace RayCaster.Teaching.Tests.Formulas;

/// <summary>The edits that people make are among those that are tried, and units keep others away.</summary>
public class EditFactoryTests
{
    [Theory]
    [InlineData("t_hc = √(R − D2)")] // an operand left out
    [InlineData("t_hc = √(R² + D2)")] // a sign
    [InlineData("t_hc = √(D2 − R²)")] // swapped
    [InlineData("t_hc = R² − D2")] // no root
    [InlineData("t_hc = √(R² − D2) / 2")]
    [InlineData("L = C − T")] // another name of the same unit
    [InlineData("L = P − C")]
    [InlineData("D2 = L·L − t_ca")]
    [InlineData("t = t_ca + t_hc")]
    public void ASphereHasThisEdit(string formula) => Assert.Contains(formula, FormulasOf(SectionKind.Sphere));

    [Theory]
    [InlineData("t_hc = √(R² − zNear)")]
    [InlineData("L = C − up")]
    [InlineData("t_ca = L·d + π")]
    public void ASphereDoesNotHaveThisEdit(string formula) => Assert.DoesNotContain(formula, FormulasOf(SectionKind.Sphere));

    [Theory]
    [InlineData("Camera", "angle = fovY·π / 200")]
    [InlineData("Camera", "angle = fovY")]
    [InlineData("Camera", "aspect = √(width / height)")]
    [InlineData("Camera", "U = normalize(W × up)")]
    [InlineData("Vectors", "cross(a, b) = (a.y·b.z − a.z·b.y, a.x·b.z − a.z·b.x, a.x·b.y − a.y·b.x)")]
    [InlineData("Rule", "hit if t > bias and z ≤ zFar")]
    [InlineData("Aabb", "t0x = (B0.x − P.x)·d.x")]
    [InlineData("Light", "att = max(0, 1 − t / |T − P|)")]
    public void AStepHasThisEdit(string kind, string formula) =>
        Assert.Contains(formula, FormulasOf(Enum.Parse<SectionKind>(kind)));

    [Fact]
    public void TheSameSlipIsMadeInAllFormulasThatAreAlike() =>
        Assert.Contains(EditFactory.EditsOf(FormulaBook.Slides[SectionKind.Aabb, "slabs"]), edit =>
            edit.Section.Formulas.Count(formula => formula.Right.ToString().Contains('·', StringComparison.Ordinal)) == 6);

    private static IEnumerable<string> FormulasOf(SectionKind kind) =>
        from edit in EditFactory.EditsOf(FormulaBook.Slides.StylesOf(kind)[0])
        from formula in edit.Section.Formulas
        where !edit.Right.Formulas.Contains(formula)
        select formula.ToString();
}
