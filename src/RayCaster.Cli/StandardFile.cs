using System.Text;
using Microsoft.Win32.SafeHandles;

namespace RayCaster.Cli;

/// <summary>
/// Standard output and standard error as plain files. The console's own streams would swallow that the reader of a picture has gone, and
/// take a quarter of the time of a program that only says hello. On Windows they are used nevertheless: a console there has its own encoding.
/// </summary>
internal static class StandardFile
{
    private const int Output = 1, Error = 2;

    /// <summary>Whether something was written to standard output, or at least begun.</summary>
    public static bool HasTakenBytes { get; private set; }

    /// <summary>Writes a command's answer.</summary>
    /// <param name="text">Whole lines.</param>
    /// <exception cref="ProblemException">Nobody takes it.</exception>
    public static void WriteOutput(string text) => WriteOutput(stream => stream.Write(Encoding.UTF8.GetBytes(WithoutControls(text))));

    /// <summary>Has something written to standard output.</summary>
    /// <exception cref="ProblemException">Nobody takes it.</exception>
    public static void WriteOutput(Action<Stream> write)
    {
        try
        {
            using var stream = OpenOutput();
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
            throw new ProblemException($"raycaster: cannot write to standard output: {Reason(e)}");
        }
    }

    private static Stream OpenOutput() => OperatingSystem.IsWindows() ? Console.OpenStandardOutput() : Open(Output);

    /// <summary>
    /// Writes what is still buffered and moves the place where other processes write that share the file: "(raycaster … -o -; date) &gt; file".
    /// </summary>
    private static void Leave(Stream stream)
    {
        if (stream is FileStream file) _ = file.SafeFileHandle; // a FileStream keeps its own place until it shows its handle
    }

    /// <summary>Tells the user something; where nobody can read it, nobody misses it.</summary>
    /// <param name="text">Whole lines.</param>
    public static void WriteError(string text)
    {
        if (text.Length == 0) return;
        text = WithoutControls(text);
        if (OperatingSystem.IsWindows())
        {
            Console.Error.Write(text);
            return;
        }
        try
        {
            using var error = Open(Error); // anew for each message: standard output may be the same file
            error.Write(Encoding.UTF8.GetBytes(text));
            Leave(error);
        }
        catch (Exception e) when (IsRefusal(e))
        {
        }
    }

    /// <summary>What is not ours, such as the name of the current folder, may hold what moves a terminal's cursor.</summary>
    private static string WithoutControls(string text) => string.Create(text.Length, text, (span, from) =>
    {
        for (var i = 0; i < span.Length; i++)
            span[i] = from[i] is '\n' or '\t' || (from[i] == '\r' && from.AsSpan(i).StartsWith("\r\n")) || PrintableText.IsPrintable(from[i])
                ? from[i]
                : '\uFFFD';
    });

    /// <summary>A closed file is refused in the second way, one that grows larger than the system allows in the third.</summary>
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
