using System.Text.RegularExpressions;

namespace RayCaster.Teaching.Explanations;

/// <summary>The source text of a formula in the notation of the slides: "(Q − P) · n / (d · n)".</summary>
internal static partial class Notation
{
    private static readonly Dictionary<string, string> slides = new (string Code, string Slide)[]
    {
        ("ray.Origin", "P"), ("ray.Direction", "d"), ("ray.At", "X"), ("Point", "Q"), ("Normal", "n"), ("Center", "C"), ("Radius", "R"),
        ("PlaneWidth", "w"), ("PlaneHeight", "h"), ("Width", "width"), ("Height", "height"), ("Camera.FadeDistance", "(2 |T − P|)"),
        ("x.Near", "x enters"), ("y.Near", "y enters"), ("z.Near", "z enters"), // as the table of slabs has it
        ("x.Far", "x leaves"), ("y.Far", "y leaves"), ("z.Far", "z leaves"),
        ("N.Sqrt", "√"), ("N.Min", "min"), ("N.Max", "max"), ("*", "·"), ("-", "−"), ("<=", "≤"), (">=", "≥"), ("&", "and"), ("|", "or"),
    }.ToDictionary(word => word.Code, word => word.Slide);

    /// <summary>The formula on one line, without brackets around it.</summary>
    public static string Format(string code)
    {
        var text = string.Join(' ', code.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries));
        if (text.StartsWith('(') && IsOpenToItsEnd(text)) return Format(text[1..^1]);
        text = Word().Replace(text, word => slides.GetValueOrDefault(word.Value, word.Value));
        return Normalised().Replace(Scaled().Replace(Square().Replace(text, "$1²"), " "), "$1 normalised");
    }

    /// <summary>Whether the first bracket is closed by the last character only.</summary>
    private static bool IsOpenToItsEnd(string text)
    {
        var depth = 0;
        return text.SkipLast(1).All(c => (depth += c switch { '(' => 1, ')' => -1, _ => 0 }) > 0);
    }

    [GeneratedRegex(@"[\w.]+|[<>]=|[-*&|]")]
    private static partial Regex Word();

    [GeneratedRegex(@"(?<![\w.])(\w+) · \1(?![\w.])")]
    private static partial Regex Square();

    /// <summary>The sign between a number and a vector, which the slides leave out: "uc U".</summary>
    [GeneratedRegex(@"(?<=\b[a-z]+) · (?=[A-Z]\b)")]
    private static partial Regex Scaled();

    [GeneratedRegex(@"(\w+) / √\(\1²\)")]
    private static partial Regex Normalised();
}
