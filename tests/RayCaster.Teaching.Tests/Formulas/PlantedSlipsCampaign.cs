
namespace RayCaster.Teaching.Tests.Formulas;

/// <summary>Slips that the catalogue does not have are found in their step.</summary>
[Trait("runs", "weekly")]
public class PlantedSlipsCampaign(ITestOutputHelper output)
{
    private static readonly string[] scenes = ["mistakes/generic", "mistakes/portrait", "mistakes/inside"];

    [Fact(Explicit = true)]
    public void MostSlipsAreFoundInTheirStep()
    {
        var (shown, right, none) = (0, 0, 0);
        for (var i = 0; i < PlantedSlips.All.Length; i++)
        {
            var (section, what, _) = PlantedSlips.All[i];
            var diagnosis = Diagnose(scenes[i % scenes.Length], i);
            var named = diagnosis.Suspects.FirstOrDefault()?.Mistakes[0];
            output.WriteLine($"{diagnosis.Finding}\t{section}: {what}\t{named?.Id} {named?.Place}");
            if (diagnosis.Finding is not (Finding.Mistake or Finding.NoneOfThese)) continue; // it does not show, or a shape is lost
            shown++;
            if (named is null) none++;
            else if ((named.Affects & Mistake.AffectedBy(Enum.Parse<SectionKind>(section, ignoreCase: true))) != 0) right++;
        }
        output.WriteLine($"{right} of {shown} in the right step, {none} not named");
        Assert.InRange(right, 0.9 * shown, shown);
        Assert.InRange(none, 0, 0.05 * shown);
    }

    private static Diagnosis Diagnose(string name, int slip)
    {
        var scene = SceneFolder.Small(name);
        return Diagnosis.Of(scene, new PlantedSlips(scene, slip).Draw());
    }
}
