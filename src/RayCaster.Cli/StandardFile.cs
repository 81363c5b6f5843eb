using Microsoft.Win32.SafeHandles;

namespace RayCaster.Cli;

/// <summary>
/// Standard output and standard error as plain files. The console's streams do not report that the reader of a picture has closed the pipe, and
/// they take a quarter of the time of a minimal program. Windows still uses them, because its consoles have their own encoding.
/// </summary>
internal static class StandardFile
{
    private const int Output = 1, Error = 2;

    /// <summary>Whether a write to standard output was begun.</summary>
    public static bool HasTakenBytes { get; private set; }

    /// <summary>Writes a command's answer, in whole lines, to standard output.</summary>
    public static void WriteOutput(string text) => WriteOutput(stream => stream.Write(Encoding.UTF8.GetBytes(Lines(text))));

    /// <exception cref="ProblemException">Standard output cannot be written.</exception>
    public static void WriteOutput(Action<Stream> write)
    {
        try
        {
            using var stream = OperatingSystem.IsWindows() ? Console.OpenStandardOutput() : Open(Output);
            HasTakenBytes = true;
            try
            {
                write(stream);
            }
            finally
            {
                Leave(stream);
            }
        }
        catch (Exception e) when (IsRefusal(e))
        {
            throw new ProblemException($"cannot write to standard output: {Reason(e)}");
        }
    }

    /// <summary>
    /// Writes the buffer, and moves the position at which other processes write to the same file, as in "(raycaster … -o -; date) &gt; file".
    /// </summary>
    private static void Leave(Stream stream)
    {
        if (stream is FileStream file) _ = file.SafeFileHandle; // a FileStream keeps its own position until its handle is used
    }

    /// <summary>Writes a message, in whole lines, to standard error. Errors of the write are ignored.</summary>
    public static void WriteError(string text)
    {
        if (text.Length == 0) return;
        text = Lines(text);
        if (OperatingSystem.IsWindows())
        {
            Console.Error.Write(text);
            return;
        }
        try
        {
            using var error = Open(Error); // opened for each message, because standard output may be the same file
            error.Write(Encoding.UTF8.GetBytes(text));
            Leave(error);
        }
        catch (Exception e) when (IsRefusal(e))
        {
        }
    }

    /// <summary>The text with a line end, and without control characters: even the name of the current folder may contain some.</summary>
    private static string Lines(string text) => PrintableText.Of(text is "" or [.., '\n'] ? text : text + Environment.NewLine, ofLines: true);

    /// <summary>A closed file gives the second kind of exception, a file that is larger than the system allows the third.</summary>
    private static bool IsRefusal(Exception e) => e is IOException or UnauthorizedAccessException or ArgumentOutOfRangeException;

    private static string Reason(Exception e) => e switch
    {
        UnauthorizedAccessException => "it is closed",
        ArgumentOutOfRangeException => "the file is larger than the system allows",
        _ => e.Message,
    };

    private static FileStream Open(int descriptor)
    {
        try
        {
            return new(new SafeFileHandle(descriptor, ownsHandle: false), FileAccess.Write);
        }
        catch (ArgumentException e)
        {
            throw new UnauthorizedAccessException(null, e);
        }
    }
}
