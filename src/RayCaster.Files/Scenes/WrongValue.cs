namespace RayCaster.Files;

/// <summary>The words of a message about a wrong value in a scene file. They follow the value's path.</summary>
internal static class WrongValue
{
    public static string Number(JsonValue value, Limits limits)
    {
        if (value.Kind == JsonTokenType.Number)
            return double.IsFinite(value.Number)
                ? $" must be {limits.Words}, but is {value.AsWritten}"
                : $" must be finite, but {value.AsWritten} is beyond the largest number, 1.8e308";
        var isQuoted = value.Kind == JsonTokenType.String && double.TryParse(value.Text, NumberStyles.Float, CultureInfo.InvariantCulture, out _);
        return $" must be a number, but is {value.InWords}{(isQuoted ? "; remove the quotes" : "")}";
    }

    /// <summary>An array that has not three elements, or no array.</summary>
    public static string Vector(JsonValue value, string form)
    {
        if (value.Kind != JsonTokenType.StartArray) return $" must be {form}, but is {value.InWords}";
        var elements = value.Content.ToArray();
        return $" must be {form}, but has {elements.Length} element{(elements.Length == 1 ? "" : "s")}{DecimalComma(elements)}";
    }

    public static string Word(JsonValue value, string[] words) =>
        $" must be {OneOf(words)}, but is {value.AsWritten}{Spelling.DidYouMean(value.Text, words)}";

    /// <summary><c>"corner" or "center"</c>.</summary>
    public static string OneOf(string[] words)
    {
        var quoted = Array.ConvertAll(words, word => $"\"{word}\"");
        return quoted.Length == 1 ? quoted[0] : $"{string.Join(", ", quoted[..^1])} or {quoted[^1]}";
    }

    /// <summary>[2,5, 0, 0] probably means [2.5, 0, 0]: a whole number follows a comma without a space.</summary>
    private static string DecimalComma(JsonValue[] elements)
    {
        for (var i = 1; i < elements.Length && elements.Length > 3; i++)
        {
            var (whole, fraction) = (elements[i - 1], elements[i]);
            if (fraction.Start == whole.End + 1 && IsWhole(whole) && IsWhole(fraction) && fraction.Number >= 0)
                return $"; a decimal comma? Write {whole.AsWritten}.{fraction.AsWritten}";
        }
        return "";

        static bool IsWhole(JsonValue value) => value.Kind == JsonTokenType.Number && !value.AsWritten.AsSpan().ContainsAny('.', 'e', 'E');
    }
}
