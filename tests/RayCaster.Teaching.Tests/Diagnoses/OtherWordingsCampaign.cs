
namespace RayCaster.Teaching.Tests.Diagnoses;

/// <summary>Known mistakes, written as the slides suggest them, in the catalogue's words or not.</summary>
public class OtherWordingsCampaign(ITestOutputHelper output)
{
    private static readonly string[] scenes = ["mistakes/generic", "mistakes/portrait", "mistakes/inside"];

    [Fact(Explicit = true)]
    public void MostAreNamed()
    {
        var (shown, named, inStep) = (0, 0, 0);
        var times = new List<double>();
        for (var i = 0; i < OtherWordings.All.Length; i++)
        {
            var (ids, section, what) = OtherWordings.All[i];
            var scene = SceneFolder.Small(scenes[i % scenes.Length], 3);
            var picture = new OtherWordings(scene, what).Draw();
            var before = Environment.CpuUsage.TotalTime;
            var diagnosis = Diagnosis.Of(scene, picture);
            times.Add((Environment.CpuUsage.TotalTime - before).TotalSeconds);
            var first = diagnosis.Suspects.FirstOrDefault();
            var suspects = diagnosis.Suspects.Select(suspect => string.Join("+", suspect.Mistakes.Select(mistake => mistake.Id)));
            output.WriteLine($"{times[^1]:0.0} s\t{diagnosis.Finding}\t{ids}: {what}\t{string.Join(' ', suspects)} {first?.Mistakes[0].Place}");
            if (diagnosis.Finding is Finding.Matches or Finding.TellsNothing or Finding.Unfinished) continue; // it does not show, or a shape is lost
            shown++;
            if (first is { Mistakes: [var only] } && first.Twins.Append(only).Any(mistake => ids.Split(' ').Contains(mistake.Id))) named++;
            else if (first?.Mistakes is [{ Place: { } place }] && place.Section.Contains(section, StringComparison.Ordinal)) inStep++;
        }
        times.Sort();
        Assert.InRange(named, 0.95 * shown, shown);
        output.WriteLine($"{named} of {shown} named, {inStep} more in the right step; "
            + $"median {times[times.Count / 2]:0.0} s, most {times[^1]:0.0} s");
    }
}
