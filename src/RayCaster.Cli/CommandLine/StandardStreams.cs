namespace RayCaster.Cli;

internal static class StandardStreams
{
    /// <summary>The name of standard input and of standard output on the command line.</summary>
    public const string Name = "-";

    /// <summary>Whether a write to standard output was begun.</summary>
    public static bool HasOutput { get; private set; }

    /// <summary>Lets a console of Windows show UTF-8, until the process ends; others have it already.</summary>
    public static void UseUtf8()
    {
        if (!OperatingSystem.IsWindows()) return;
        var before = Console.OutputEncoding;
        Console.OutputEncoding = Encoding.UTF8;
        AppDomain.CurrentDomain.ProcessExit += (_, _) => Console.OutputEncoding = before;
    }

    /// <summary>Writes a command's answer, in whole lines, to standard output.</summary>
    /// <exception cref="ProblemException">Standard output cannot be written.</exception>
    public static void WriteOutput(string text) => OutputFile.Write(Name, Bytes(text));

    public static Stream OpenOutput()
    {
        HasOutput = true;
        return Console.OpenStandardOutput();
    }

    /// <summary>Writes a message, in whole lines, to standard error. Errors of the write are ignored.</summary>
    public static void WriteError(string text)
    {
        if (text.Length == 0) return;
        try
        {
            using var stream = Console.OpenStandardError();
            stream.Write(Bytes(text));
        }
        catch (Exception e) when (ProblemException.IsCausedByFile(e))
        {
        }
    }

    /// <summary>The text in lines that end with LF on every system, without control characters: even the name of the current folder may contain
    /// some.</summary>
    private static byte[] Bytes(string text) =>
        Encoding.UTF8.GetBytes(PrintableText.From((text is "" or [.., '\n'] ? text : text + '\n').Replace("\r\n", "\n"), ofLines: true));
}
