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

    /// <summary>Opens standard output. <see cref="Leave"/> is to follow.</summary>
    public static Stream OpenOutput() => OperatingSystem.IsWindows() ? Console.OpenStandardOutput() : Open(Output);

    /// <summary>
    /// Writes what is still buffered and moves the place where other processes write that share the file: "(raycaster … -o -; date) &gt; file".
    /// </summary>
    public static void Leave(Stream stream)
    {
        if (stream is FileStream file) _ = file.SafeFileHandle; // a FileStream keeps its own place until it shows its handle
    }

    /// <summary>Writes a command's answer.</summary>
    /// <param name="text">Whole lines.</param>
    /// <exception cref="ProblemException">Nobody takes it.</exception>
    public static void WriteOutput(string text)
    {
        try
        {
            using var stream = OpenOutput();
            stream.Write(Encoding.UTF8.GetBytes(text));
            Leave(stream);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            throw new ProblemException($"raycaster: cannot write to standard output: {e.Message}");
        }
    }

    /// <summary>Tells the user something; where nobody can read it, nobody misses it.</summary>
    /// <param name="text">Whole lines.</param>
    public static void WriteError(string text)
    {
        if (text.Length == 0) return;
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
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException)
        {
        }
    }

    private static FileStream Open(int descriptor) => new(new SafeFileHandle(descriptor, ownsHandle: false), FileAccess.Write);
}
