using System.Text.RegularExpressions;

namespace RayCaster.Files;

/// <summary>What people copy into JSON from programs and from git.</summary>
internal static partial class JsonForeign
{
    public const string Merge = "an unfinished merge of git";

    /// <summary>Whether a line is one of those that git writes where two versions differ.</summary>
    public static bool IsMergeMarker(ReadOnlySpan<byte> line) =>
        line.StartsWith("<<<<<<<"u8) || line.StartsWith("|||||||"u8) || line.StartsWith("======="u8) || line.StartsWith(">>>>>>>"u8);

    /// <summary>Whether a word at the end of a file may be the beginning of a number.</summary>
    public static bool IsBegunNumber(string word) => BegunNumber().Match(word).Length == word.Length;

    /// <summary>The word in other terms; null where nothing is known of it.</summary>
    public static string? Explain(string word)
    {
        if (NotFinite().IsMatch(word)) return $"{word} is not allowed; a number must be finite";
        if (word.ToLowerInvariant() is "true" or "false") return $"{word} is written {word.ToLowerInvariant()} in JSON";
        if (NoValue().IsMatch(word)) return $"{word} is how other languages write \"no value\": write a number, or leave the key out";
        if (word.StartsWith("0x", StringComparison.OrdinalIgnoreCase)) return $"numbers are decimal; {word} is not";
        if (IsBegunNumber(word)) return $"{word} is not a number; a digit is missing, as in -1, 0.5 or 1e-6";
        if (BegunNumber().Match(word).Length is > 0 and var length)
            return $"{word} is not a number; a number ends before '{Rune.GetRuneAt(word, length)}'";
        if (!char.IsLetter(word[0]) && word[0] != '_') return $"a value is expected here, not '{Rune.GetRuneAt(word, 0)}'";
        return word.AsSpan().ContainsAny('.', '(') ? $"{word} is {Language(word)}, not JSON: write its value" : null;
    }

    /// <summary>A call, a tuple or arithmetic at the beginning of a text: its length, and what to write.</summary>
    public static (int Length, string Message)? Expression(string text)
    {
        if (Arithmetic().Match(text) is { Success: true } sum)
        {
            var quotient = Number(sum.Groups["a"]) / Number(sum.Groups["b"]);
            var result = double.IsFinite(quotient) ? FormattableString.Invariant($"{quotient}") : "the result";
            return (sum.Length, $"{sum.Value} is not a number, and JSON does not calculate: write {result}");
        }
        if (Call().Match(text) is not { Success: true } call) return null;
        var code = call.Value;
        var inner = call.Groups["inner"].Value;
        if (NotFinite().IsMatch(inner.Trim('\'', '"'))) return (call.Length, $"{code} is not allowed; a number must be finite");
        var numbers = Array.ConvertAll(NamedArgument().Replace(inner, "").Split(','), word => NumberSpelling.Correct(word.Trim([.. " []()'\""])));
        var write = numbers.Contains(null) ? "its value"
            : numbers.Length == 3 ? $"[{string.Join(", ", numbers)}]"
            : numbers.Length == 1 && Cast().IsMatch(call.Groups["name"].Value) ? numbers[0] : "its value";
        return (call.Length, $"{code} is {Language(code)}, not JSON: write {write}");
    }

    private static double Number(Group group) =>
        double.TryParse(group.ValueSpan, CultureInfo.InvariantCulture, out var number) ? number : double.NaN;

    private static string Language(string code) => Python().IsMatch(code) ? "Python" : "code of a program";

    [GeneratedRegex(@"^[+-]?([A-Za-z_][\w.]*\.)?(nan|inf|infinity|(positive|negative)_?infinity|∞|(1\.)?#(inf|ind|qnan|snan)\w*)(\(\w*\))?$",
        RegexOptions.IgnoreCase)]
    private static partial Regex NotFinite();

    [GeneratedRegex("^(none|nil|null|undefined|nullptr|nothing|n/?a)$", RegexOptions.IgnoreCase)]
    private static partial Regex NoValue();

    [GeneratedRegex(@"^[+-]?([0-9]+(\.[0-9]*)?(e[+-]?[0-9]*)?)?", RegexOptions.IgnoreCase)]
    private static partial Regex BegunNumber();

    // A name with what stands between its parentheses, or a tuple; the value of one number in parentheses is the number.
    [GeneratedRegex(@"^(new\s+)?(?<name>[A-Za-z_][\w.:<>]*)?\s*\((?<inner>[^()]*|\([^()]*\))\)")]
    private static partial Regex Call();

    [GeneratedRegex(@"(^|\.)((float|double|int|long|uint|decimal|number|array|tensor|f|i)_?[0-9]*)?$", RegexOptions.IgnoreCase)]
    private static partial Regex Cast();

    [GeneratedRegex(@"^(np|numpy|array|tensor|torch|math|float|int|Decimal|Fraction|tuple|list)\b")]
    private static partial Regex Python();

    [GeneratedRegex(@",\s*\w+\s*=.*$")] // dtype=float32
    private static partial Regex NamedArgument();

    // A fraction of two numbers, or anything with an operator, up to a comma, a closing bracket or a comment.
    [GeneratedRegex(@"^((?<a>-?[0-9.]+)\s*/\s*(?<b>[0-9.]+)|[^\s,\]}""]*[\w.)]\s*([*^×÷·]|/(?=\s*[0-9.(])|[+-]\s)[^,\]}""]*?)"
        + @"(?=\s*([,\]}]|//|/\*|$))")]
    private static partial Regex Arithmetic();
}
