namespace RayCaster.Files;

/// <summary>Lines of a picture that follow each other, counted from the top, from 0.</summary>
/// <param name="Last">The last line, included; not less than the first.</param>
public readonly record struct LineRange(int First, int Last)
{
    /// <summary>How many lines.</summary>
    public int Count => Last - First + 1;

    /// <summary>All lines of a picture.</summary>
    public static LineRange Whole(int height) => new(0, height - 1);

    /// <summary>The same as a <see cref="Range"/>, whose end is excluded.</summary>
    public static implicit operator Range(LineRange lines) => lines.First..(lines.Last + 1);

    /// <summary>Reads what <see cref="ToString"/> writes; null for any other text.</summary>
    public static LineRange? Parse(string text) =>
        text.Split("..") is [var a, var b] && Number(a) is { } first && Number(b) is { } last && first <= last ? new(first, last) : null;

    /// <summary>The form of the command line: <c>0..249</c> for the lines 0 to 249, both included.</summary>
    public override string ToString() => string.Create(CultureInfo.InvariantCulture, $"{First}..{Last}");

    private static int? Number(string text) => int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out var number) ? number : null;
}
