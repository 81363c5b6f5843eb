using System.Xml;
using System.Xml.Linq;

namespace RayCaster.Teaching;

/// <summary>The marks as JUnit XML: a suite for each student, a case for each item. It has no answers. A program without any picture
/// is an error, not a skipped test: a reader of the sums alone must see it.</summary>
internal static class JUnitReport
{
    public static string Of(Rubric rubric, IReadOnlyList<StudentMarks> marks) =>
        $"{new XDeclaration("1.0", "utf-8", null)}\n{new XElement("testsuites", Text("name", rubric.Title), marks.Select(Suite))}\n";

    private static XElement Suite(StudentMarks student)
    {
        XElement[] cases =
        [
            .. student.Items.Select(item =>
                new XElement("testcase", Text("classname", student.Student), Text("name", item.Name), Outcome(student, item))),
        ];
        return new("testsuite", Text("name", student.Student), new XAttribute("tests", cases.Length),
            Count("failures", "failure"), Count("errors", "error"), Count("skipped", "skipped"), cases);

        XAttribute Count(string name, string outcome) => new(name, cases.Count(one => one.Element(outcome) is not null));
    }

    private static XElement? Outcome(StudentMarks student, ItemMarks item) =>
        student.CommonProblem is { } problem ? Message("error", problem)
        : item.Open > 0 ? Message("skipped", "The teacher must look: " + string.Join("; ", student.LookYourself))
        : item.Points < item.Of ? Message("failure", $"{MarksTable.Number(item.Points)} of {MarksTable.Number(item.Of)} points. " +
            string.Join(" ", item.Because.Select(MarkWords.Symptom))) // what one sees, not what is wrong
        : null;

    private static XElement Message(string element, string message) => new(element, Text("message", message));

    /// <summary>An attribute without characters that XML does not allow: a program may print any.</summary>
    private static XAttribute Text(string name, string text) => new(name, string.Concat(
        text.EnumerateRunes().Select(letter => letter.IsBmp && !XmlConvert.IsXmlChar((char)letter.Value) ? Rune.ReplacementChar : letter)));
}
