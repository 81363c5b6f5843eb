using System.Globalization;

namespace RayCaster.Files;

/// <summary>Some lines of a picture, counted from the top, 0 first.</summary>
/// <param name="First">The first line.</param>
/// <param name="Last">The last line; it belongs to them, so it is not less than the first.</param>
public readonly record struct LineRange(int First, int Last)
{
    /// <summary>How many lines.</summary>
    public int Count => Last - First + 1;

    /// <summary>All lines of a picture.</summary>
    public static LineRange Whole(int height) => new(0, height - 1);

    /// <summary>The same as the language writes it: the end does not belong to it.</summary>
    public static implicit operator Range(LineRange lines) => lines.First..(lines.Last + 1);

    /// <summary>Reads what <see cref="ToString"/> writes; null where that is not what the text says.</summary>
    public static LineRange? Parse(string text) =>
        text.Split("..") is [var a, var b] && Number(a) is { } first && Number(b) is { } last && first <= last ? new(first, last) : null;

    /// <summary>As on a command line: <c>0..249</c> are the lines 0 to 249, both included.</summary>
    public override string ToString() => string.Create(CultureInfo.InvariantCulture, $"{First}..{Last}");

    private static int? Number(string text) => int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out var number) ? number : null;
}
