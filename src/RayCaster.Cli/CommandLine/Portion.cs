namespace RayCaster.Cli;

/// <summary>Some lines of a picture, or some frames of a film: the first and the last, both included, as in 0..249, or a share, as in 3/8, the third
/// of eight equal parts.</summary>
/// <param name="text">As it was given.</param>
internal sealed class Portion(string text, Func<int, NumberRange?> of)
{
    /// <summary>Reads a portion; null for any other text.</summary>
    public static Portion? Parse(string text)
    {
        if (NumberRange.Parse(text) is { } range) return new(text, count => range.Last < count ? range : null);
        if (text.Split('/') is not [var k, var n] || Option.ReadCount(k) is not { } part || Option.ReadCount(n) is not { } parts) return null;
        if (part > parts) return null;
        return new(text, count => parts <= count ? new((int)((part - 1L) * count / parts), (int)((long)part * count / parts) - 1) : null);
    }

    /// <summary>The lines of a picture of so many; null if it has not all of them, or fewer lines than parts.</summary>
    public NumberRange? Of(int count) => of(count);

    public override string ToString() => text;
}
