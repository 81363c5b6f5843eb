namespace RayCaster.Cli;

/// <summary>Some lines of a picture, or some frames of a film: the first and the last, both included, as in 0..249, or a share, as in 3/8, the third
/// of eight equal parts.</summary>
/// <param name="text">As it was given.</param>
internal sealed class Portion(string text, Func<int, NumberRange?> of)
{
    /// <summary>Reads a portion; null for any other text.</summary>
    /// <exception cref="ProblemException">It is a share that does not exist, as 9/8.</exception>
    public static Portion? Parse(string text)
    {
        if (NumberRange.Parse(text) is { } range) return new(text, count => range.Last < count ? range : null);
        if (text.Split('/') is not [var k, var n] || Option.ReadCount(n) is not { } parts
            || !long.TryParse(k, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out var part)) return null;
        if (part < 1 || part > parts)
            throw ProblemException.Usage($"there is no part {text}: parts are 1/{parts} to {parts}/{parts} (--array=1-{parts})");
        return new(text, count => parts <= count ? new((int)((part - 1) * count / parts), (int)(part * count / parts) - 1) : null);
    }

    /// <summary>The lines of a picture of so many; null if it has not all of them, or fewer lines than parts.</summary>
    public NumberRange? Of(int count) => of(count);

    public override string ToString() => text;
}
