namespace RayCaster.Cli;

/// <summary>
/// What a word may hold that names a file or is said in a message. One with a line end could forge a line of ours, one with a mark of direction
/// could
/// turn a name around; and a name that is not UTF-8 arrives here as another one, of a file that is not there.
/// </summary>
internal static class FileWord
{
    private const char NotUtf8 = '\uFFFD';

    /// <summary>Refuses a word that could deceive.</summary>
    /// <exception cref="ProblemException">It is one; the message shows what is in it.</exception>
    public static void Check(string word)
    {
        foreach (var c in word)
        {
            if (c == NotUtf8) throw new ProblemException($"raycaster: the name '{PrintableText.Of(word)}' is not UTF-8: rename the file");
            if (PrintableText.IsPrintable(c)) continue;
            throw new ProblemException(
                $"raycaster: '{PrintableText.Of(word)}' holds the invisible character U+{(int)c:X4}: rename the file, " +
                    "or type the name anew if it was copied");
        }
    }
}
