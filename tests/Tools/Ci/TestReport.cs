using System.Xml.Linq;

namespace RayCaster.Ci;

/// <summary>A test of a report: failed if it has a message of a failure, skipped if it has a reason.</summary>
/// <param name="Program">The test program.</param>
/// <param name="Class">The test's class.</param>
/// <param name="Name">The test's full name, with its arguments.</param>
/// <param name="Failure">What failed.</param>
/// <param name="Reason">Why it was skipped.</param>
internal sealed record TestResult(string Program, string Class, string Name, string? Failure, string? Reason)
{
    /// <summary>The full name without arguments.</summary>
    public string Method => Name.StartsWith(Class, StringComparison.Ordinal) ? Name.Split('(')[0] : Name;
}

/// <summary>A JUnit report, as xunit writes it.</summary>
/// <param name="Program">The test program.</param>
/// <param name="Tests">Its tests. What failed outside of a test, as in a fixture, counts as one.</param>
internal sealed record TestReport(string Program, IReadOnlyList<TestResult> Tests)
{
    /// <summary>The reports in a folder: one for each test program.</summary>
    public static IReadOnlyList<TestReport> ReadAll(string folder) => !Directory.Exists(folder) ? []
        : [.. Directory.GetFiles(folder, "*.xml").Order().SelectMany(file => Read(XDocument.Load(file)))];

    private static IEnumerable<TestReport> Read(XDocument document) => document.Descendants("testsuite").Select(suite =>
    {
        var program = (string?)suite.Attribute("name") ?? throw new InvalidDataException("a report has a suite without a name");
        var tests = suite.Elements("testcase").Select(test => new TestResult(program, (string?)test.Attribute("classname") ?? "",
            (string?)test.Attribute("name") ?? "", Text(test.Element("failure") ?? test.Element("error")), Text(test.Element("skipped"))));
        var errors = suite.Elements("system-err").Select(error => new TestResult(program, "", Path.GetFileName(program), Text(error), null));
        return new TestReport(program, [.. tests, .. (int?)suite.Attribute("errors") > 0 ? errors : []]);
    });

    private static string? Text(XElement? element) => element is null ? null : $"{(string?)element.Attribute("message")}\n{element.Value}".Trim();
}
