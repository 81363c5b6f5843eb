using System.Text.RegularExpressions;
using System.Xml;
using System.Xml.Linq;

namespace RayCaster.Marks;

/// <summary>How many tests of a step pass, and of how many.</summary>
internal sealed record StepResult(int Step, int Passed, int Count)
{
    public bool IsPassed => Passed == Count;

    /// <summary>Whether the result is about this step: tests fail, too, if a step fails that they use.</summary>
    public bool IsConclusive(IReadOnlyDictionary<int, StepResult> all) =>
        IsPassed || !Enumerable.Range(1, Step is 4 or 5 ? 3 : 2).Any(used => used < Step && all.GetValueOrDefault(used) is { IsPassed: false });

    public override string ToString() => $"{Passed} of {Count} tests of step {Step} pass";
}

/// <summary>Counts the test results of JUnit files by step. A step's tests are those in whose class or name stands <c>step</c> and its number,
/// such as <c>Lab.Tests.Step08Sphere</c> and <c>test_step_8</c>.</summary>
internal static partial class TestResults
{
    private const int MaxBytes = 1 << 24;

    /// <summary>The hand-out's tests of whole pictures are called so. They show the mistakes of all steps before, and do not count.</summary>
    private const string OfPictures = "ThePictures";

    /// <summary>Begins the hand-out's message of a test that did not end. The tests after it did not run.</summary>
    private const string Stopped = "The run was stopped";

    /// <summary>The results by step; null if there are none.</summary>
    /// <param name="problem">Why a file was not counted; null if all were.</param>
    public static IReadOnlyDictionary<int, StepResult>? In(Submission submission, string pattern, out string? problem)
    {
        problem = null;
        var tests = new List<XElement>();
        foreach (var file in submission.FilesLike(pattern))
        {
            try
            {
                tests.AddRange(TestsIn([.. InputFile.Read(Path.Combine(submission.Folder, file), "file", MaxBytes)]));
            }
            catch (Exception e) when (e is ProblemException or XmlException)
            {
                problem = $"the test results {file} cannot be read: {e.Message}";
            }
        }
        return tests.Count == 0 ? null : ByStep(tests);
    }

    /// <exception cref="XmlException">It is no XML, or has a DTD, which could name other files.</exception>
    internal static IEnumerable<XElement> TestsIn(byte[] report)
    {
        var settings = new XmlReaderSettings { DtdProcessing = DtdProcessing.Prohibit, XmlResolver = null, CheckCharacters = false };
        using var reader = XmlReader.Create(new MemoryStream(report), settings);
        return XDocument.Load(reader).Descendants().Where(element => element.Name.LocalName == "testcase");
    }

    /// <returns>Of a run that was stopped, only the steps that fail: tests of the others may be missing.</returns>
    internal static IReadOnlyDictionary<int, StepResult> ByStep(IReadOnlyList<XElement> tests)
    {
        var isStopped = tests.Any(test => Find(test, "error")?.Attribute("message")?.Value.StartsWith(Stopped, StringComparison.Ordinal) == true);
        return tests.Where(test => Find(test, "skipped") is null && !Text(test, "name").StartsWith(OfPictures, StringComparison.Ordinal))
            .GroupBy(StepOf).Where(step => step.Key > 0)
            .Select(step => new StepResult(step.Key, step.Count(IsPassed), step.Count()))
            .Where(step => !isStopped || !step.IsPassed).ToDictionary(step => step.Step);
    }

    private static bool IsPassed(XElement test) => Find(test, "failure") is null && Find(test, "error") is null;

    private static XElement? Find(XElement test, string name) => test.Elements().FirstOrDefault(element => element.Name.LocalName == name);

    private static string Text(XElement test, string attribute) => test.Attribute(attribute)?.Value ?? "";

    private static int StepOf(XElement test) =>
        new[] { "classname", "name" }.Select(attribute => StepNumber().Match(Text(test, attribute))).FirstOrDefault(match => match.Success)
            is { } match ? int.Parse(match.Groups[1].Value, CultureInfo.InvariantCulture) : 0;

    [GeneratedRegex(@"step[ _-]?0*(\d{1,2})", RegexOptions.IgnoreCase | RegexOptions.RightToLeft | RegexOptions.CultureInvariant)]
    private static partial Regex StepNumber();
}
