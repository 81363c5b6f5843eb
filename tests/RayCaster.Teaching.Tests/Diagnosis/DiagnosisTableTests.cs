using System.Collections.Concurrent;

namespace RayCaster.Teaching.Tests.Diagnosis;

/// <summary>What is said of programs' pictures, case by case: Diagnoses.txt.</summary>
public class DiagnosisTableTests
{
    private static readonly ConcurrentDictionary<string, Diagnoser> prepared = [];

    public static IEnumerable<ITheoryDataRow> Rows => TestTable.Read("Diagnosis/Diagnoses.txt");

    [Theory]
    [MemberData(nameof(Rows))]
    public void APictureIsDiagnosed(string scene, string program, string finding, string mistakes, string notYet, string says)
    {
        var judge = prepared.GetOrAdd(scene, _ => new(SceneFolder.Small(Path.GetDirectoryName(scene)!, int.Parse(Path.GetFileName(scene)))));
        var diagnosis = judge.Diagnose(ProgramInWords.Draw(judge.Scene, program));
        Assert.Equal(finding, $"{diagnosis.Kind}");
        Assert.Equal(mistakes, Named(diagnosis, mistakes));
        Assert.Equal(notYet, string.Join(' ', diagnosis.MissingParts.Order()));
        Assert.Contains(says, DiagnosisReport.Text(diagnosis, "mine.png", "scene.json").ReplaceLineEndings(" "));
    }

    /// <summary>The mistakes of the first suspect, as the table has them where it has a twin of one.</summary>
    private static string Named(DiagnosisResult diagnosis, string expected)
    {
        if (diagnosis.Suspects is not [var suspect, ..]) return "";
        string[] twins = [.. suspect.Twins.Select(twin => twin.Id)], names = [.. suspect.Mistakes.Select(mistake => mistake.Id)];
        string[] wanted = expected.Split(" + ");
        return names.Length == wanted.Length && wanted.All(one => one.Split(" = ").All(id => names.Contains(id) || twins.Contains(id)))
            ? expected : string.Join(" + ", names.Order());
    }
}
