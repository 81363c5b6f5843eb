using System.Text.RegularExpressions;

namespace RayCaster.Files;

/// <summary>What people copy into JSON from programs and from git.</summary>
internal static partial class JsonForeign
{
    public const string Merge = "an unfinished merge of git";

    public static bool IsMergeMarker(ReadOnlySpan<byte> line) =>
        line.StartsWith("<<<<<<<"u8) || line.StartsWith("|||||||"u8) || line.StartsWith("======="u8) || line.StartsWith(">>>>>>>"u8);

    /// <summary>Whether a word at the end of a file may be the beginning of a number.</summary>
    public static bool IsBegunNumber(string word) => BegunNumber().Match(word).Length == word.Length;

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
        return word.AsSpan().ContainsAny('.', '(') ? $"{word} is code of a program, not JSON: write its value" : null;
    }

    [GeneratedRegex(@"^[+-]?([A-Za-z_][\w.]*\.)?(nan|inf|infinity|(positive|negative)_?infinity|∞|(1\.)?#(inf|ind|qnan|snan)\w*)(\(\w*\))?$",
        RegexOptions.IgnoreCase)]
    private static partial Regex NotFinite();

    [GeneratedRegex("^(none|nil|null|undefined|nullptr|nothing|n/?a)$", RegexOptions.IgnoreCase)]
    private static partial Regex NoValue();

    [GeneratedRegex(@"^[+-]?([0-9]+(\.[0-9]*)?(e[+-]?[0-9]*)?)?", RegexOptions.IgnoreCase)]
    private static partial Regex BegunNumber();
}
