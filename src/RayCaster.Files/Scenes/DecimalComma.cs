namespace RayCaster.Files;

/// <summary>Decimal commas that JSON takes for the commas of an array: [0,866, 0, 0] is [0.866, 0, 0].</summary>
internal static class DecimalComma
{
    /// <summary>How an array of four to six numbers is one of three: <c>; a decimal comma? Write [2.5, 0, 0]</c>. Empty for any other.</summary>
    public static string Hint(JsonValue[] elements)
    {
        var readings = elements.Length <= 6 ? Readings(elements, elements.Length - 3).ToArray() : [];
        return readings.Length == 0 || elements.Length <= 3 ? ""
            : $"; a decimal comma? Write {string.Join(" or ", readings.Select(reading => $"[{string.Join(", ", reading)}]"))}";
    }

    private static IEnumerable<string[]> Readings(ArraySegment<JsonValue> elements, int pairs)
    {
        if (pairs > elements.Count / 2 || elements.Count == 0) return pairs == 0 ? [[]] : [];
        var joined = pairs > 0 && elements.Count > 1 && IsFraction(elements[0], elements[1])
            ? Readings(elements[2..], pairs - 1).Select(rest => (string[])[$"{elements[0].AsWritten}.{elements[1].AsWritten}", .. rest]) : [];
        return joined.Concat(Readings(elements[1..], pairs).Select(rest => (string[])[elements[0].AsWritten, .. rest]));
    }

    private static bool IsFraction(JsonValue whole, JsonValue fraction) =>
        fraction.Start == whole.End + 1 && whole.IsWholeNumber && fraction.IsWholeNumber && fraction.Number >= 0;
}
