namespace RayCaster.Cli;

/// <summary>
/// Refuses dangerous characters in file names and other words of messages. A line end could forge a line of output, and a direction mark could
/// show a name in reverse. A name that is not UTF-8 arrives here as the name of another file, which does not exist.
/// </summary>
internal static class FileWord
{
    private const char NotUtf8 = '\uFFFD';

    public static void Check(string word)
    {
        foreach (var c in word)
        {
            if (c == NotUtf8) throw new ProblemException($"the name '{PrintableText.From(word)}' is not UTF-8: rename the file");
            if (PrintableText.IsPrintable(c)) continue;
            throw new ProblemException(
                $"'{PrintableText.From(word)}' holds the invisible character U+{(int)c:X4}: rename the file, " +
                    "or type the name again if it was copied");
        }
    }
}
