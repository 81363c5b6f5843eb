using System.Globalization;
using System.Text;
using System.Xml;

namespace RayCaster.Teaching;

/// <summary>The marks as JUnit XML: a suite for each student, a case for each item. It has no answers. A program without any picture
/// is an error, not a skipped test: whoever reads only the sums must see it.</summary>
internal static class JUnitReport
{
    public static string Of(Rubric rubric, IReadOnlyList<StudentMarks> marks)
    {
        using var text = new MemoryStream();
        using (var xml = XmlWriter.Create(text, new() { Encoding = new UTF8Encoding(false), Indent = true, CheckCharacters = true }))
        {
            xml.WriteStartElement("testsuites");
            xml.WriteAttributeString("name", Clean(rubric.Title));
            foreach (var student in marks) WriteSuite(xml, student);
            xml.WriteEndElement();
        }
        return Encoding.UTF8.GetString(text.ToArray()) + "\n";
    }

    private static void WriteSuite(XmlWriter xml, StudentMarks student)
    {
        xml.WriteStartElement("testsuite");
        xml.WriteAttributeString("name", Clean(student.Student));
        Count("tests", student.Items.Count);
        Count("failures", student.Items.Count(IsLost));
        Count("errors", student.CommonProblem is null ? 0 : student.Items.Count);
        Count("skipped", student.CommonProblem is null ? student.Items.Count(item => item.Open > 0) : 0);
        foreach (var item in student.Items)
        {
            xml.WriteStartElement("testcase");
            xml.WriteAttributeString("classname", Clean(student.Student));
            xml.WriteAttributeString("name", Clean(item.Name));
            if (student.CommonProblem is { } problem) WriteMessage(xml, "error", problem);
            else if (item.Open > 0) WriteMessage(xml, "skipped", "The teacher must look: " + string.Join("; ", student.LookYourself));
            else if (IsLost(item))
                WriteMessage(xml, "failure", $"{MarksTable.Number(item.Points)} of {MarksTable.Number(item.Of)} points. {MarkWords.Symptoms(item)}");
            xml.WriteEndElement();
        }
        xml.WriteEndElement();

        void Count(string name, int count) => xml.WriteAttributeString(name, count.ToString(CultureInfo.InvariantCulture));
    }

    private static bool IsLost(ItemMarks item) => item.Open == 0 && item.Points < item.Of;

    private static void WriteMessage(XmlWriter xml, string element, string message)
    {
        xml.WriteStartElement(element);
        xml.WriteAttributeString("message", Clean(message));
        xml.WriteEndElement();
    }

    /// <summary>The text without characters that XML does not allow: a program may print any.</summary>
    private static string Clean(string text) => string.Concat(text.Select(letter => XmlConvert.IsXmlChar(letter) ? letter : '\uFFFD'));
}
