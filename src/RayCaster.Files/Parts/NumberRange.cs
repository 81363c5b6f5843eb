namespace RayCaster.Files;

/// <summary>Numbers that follow each other: of the lines of a picture, counted from the top, from 0; of frames; of steps.</summary>
/// <param name="Last">The last number, included; not less than the first.</param>
internal readonly record struct NumberRange(int First, int Last)
{
    public int Count => Last - First + 1;

    public static NumberRange Whole(int count) => new(0, count - 1);

    /// <summary>Reads what <see cref="ToString"/> writes; null for any other text.</summary>
    public static NumberRange? Parse(string text) =>
        text.Split("..") is [var a, var b] && Number(a) is { } first && Number(b) is { } last && first <= last ? new(first, last) : null;

    /// <summary>The form of the command line: <c>0..249</c> for 0 to 249, both included.</summary>
    public override string ToString() => string.Create(CultureInfo.InvariantCulture, $"{First}..{Last}");

    private static int? Number(string text) => int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out var number) ? number : null;
}
