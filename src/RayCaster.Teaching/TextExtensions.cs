using System.Text.Json;

namespace RayCaster.Teaching;

/// <summary>Helpers for texts that people read.</summary>
public static class TextExtensions
{
    /// <param name="value">Any value.</param>
    extension(Enum value)
    {
        /// <summary>The name in small letters, with blanks between its words.</summary>
        public string Words => JsonNamingPolicy.KebabCaseLower.ConvertName(value.ToString()).Replace('-', ' ');
    }

    /// <summary>Appends words in lines that a terminal shows whole.</summary>
    /// <param name="text">The lines so far.</param>
    /// <param name="head">What the first line begins with.</param>
    /// <param name="words">A paragraph.</param>
    /// <param name="hang">How far all lines but the first are indented; as long as the head if left out.</param>
    /// <param name="width">The most characters of a line.</param>
    public static void Wrap(this StringBuilder text, string head, string words, int? hang = null, int width = 96)
    {
        var line = new StringBuilder(head);
        var start = head.Length;
        foreach (var word in words.Split(' '))
        {
            if (line.Length + word.Length > width && line.Length > start)
            {
                text.Append(line.ToString().TrimEnd()).Append('\n');
                start = hang ?? head.Length;
                line.Clear().Append(' ', start);
            }
            line.Append(word).Append(' ');
        }
        text.Append(line.ToString().TrimEnd()).Append('\n');
    }
}
