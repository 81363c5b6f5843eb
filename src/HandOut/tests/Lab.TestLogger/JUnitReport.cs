using System.Globalization;
using System.Xml;
using Microsoft.VisualStudio.TestPlatform.ObjectModel;

namespace Lab.TestLogger;

/// <summary>The results as GitLab and others read them.</summary>
internal static class JUnitReport
{
    /// <param name="stopped">Tests that did not come to their ends.</param>
    public static void Write(string file, IReadOnlyCollection<TestResult> results, IReadOnlyCollection<TestResult> stopped)
    {
        Directory.CreateDirectory(Path.GetDirectoryName(file));
        using var xml = XmlWriter.Create(file, new XmlWriterSettings { Indent = true, CheckCharacters = false });
        xml.WriteStartElement("testsuites");
        xml.WriteStartElement("testsuite");
        xml.WriteAttributeString("name", "Lab");
        xml.WriteAttributeString("tests", Number(results.Count + stopped.Count));
        xml.WriteAttributeString("failures", Number(results.Count(result => result.Outcome == TestOutcome.Failed)));
        xml.WriteAttributeString("errors", Number(stopped.Count));
        foreach (var result in results)
            Write(xml, result, result.Outcome switch { TestOutcome.Passed => null, TestOutcome.Failed => "failure", _ => "skipped" });
        foreach (var test in stopped) Write(xml, test, "error");
        xml.WriteEndElement();
        xml.WriteEndElement();
    }

    /// <param name="problem">"failure", "error" or "skipped", or null for a test that has passed.</param>
    private static void Write(XmlWriter xml, TestResult result, string problem)
    {
        var name = result.TestCase.FullyQualifiedName;
        xml.WriteStartElement("testcase");
        xml.WriteAttributeString("classname", name[..name.LastIndexOf('.')]);
        xml.WriteAttributeString("name", result.DisplayName[(result.DisplayName.IndexOf('(') is >= 0 and var end
            ? result.DisplayName.LastIndexOf('.', end) + 1 : result.DisplayName.LastIndexOf('.') + 1)..]);
        xml.WriteAttributeString("time", Number(result.Duration.TotalSeconds));
        if (problem != null)
        {
            xml.WriteStartElement(problem);
            xml.WriteAttributeString("message", (result.ErrorMessage ?? "").Split('\n')[0]);
            xml.WriteString(result.ErrorMessage);
            xml.WriteEndElement();
        }
        xml.WriteEndElement();
    }

    private static string Number(double number) => number.ToString(CultureInfo.InvariantCulture);
}
