using System.Runtime.InteropServices;

namespace RayCaster.Cli;

internal static class Program
{
    /// <summary>The signal for a file that is larger than "ulimit -f" allows; the same number on Linux and macOS.</summary>
    private const PosixSignal FileTooLarge = (PosixSignal)25;

    internal static int Main(string[] arguments)
    {
        using var cancellation = new CancellationTokenSource();
        var exitCode = ExitCode.Interrupted;
        void Cancel(PosixSignalContext context)
        {
            context.Cancel = true; // the default would end the process and leave the temporary file
            exitCode = context.Signal switch
            {
                PosixSignal.SIGHUP => ExitCode.HungUp,
                PosixSignal.SIGTERM => ExitCode.Terminated,
                _ => ExitCode.Interrupted,
            };
            cancellation.Cancel();
        }
        using var interrupt = PosixSignalRegistration.Create(PosixSignal.SIGINT, Cancel);
        using var hangUp = PosixSignalRegistration.Create(PosixSignal.SIGHUP, Cancel); // the terminal window was closed
        using var terminate = PosixSignalRegistration.Create(PosixSignal.SIGTERM, Cancel);
        // By default it ends the process. Ignored, the write fails with a message. Not disposed: the signal may come later.
        var tooLarge = OperatingSystem.IsWindows() ? null : PosixSignalRegistration.Create(FileTooLarge, context => context.Cancel = true);

        try
        {
            return Abandonable.Run(() => Run(arguments, cancellation.Token), cancellation.Token);
        }
        catch (Exception) when (cancellation.IsCancellationRequested) // after a cancellation, writing may fail because the terminal is gone
        {
            Interruption.Tell(arguments);
            return exitCode;
        }
        catch (Exception e) when (Message(e) is { } message)
        {
            StandardFile.WriteError(message + Environment.NewLine);
            if (e is ProblemException { IsUsage: true }) StandardFile.WriteError(HelpText.HintAfter(arguments));
            return ExitCode.CouldNot;
        }
        catch (Exception unexpected)
        {
            return Report(unexpected);
        }
        finally
        {
            GC.KeepAlive(tooLarge);
        }
    }

    /// <summary>What to tell the user; null for a fault of this program.</summary>
    private static string? Message(Exception e) => e switch
    {
        ProblemException => e.Message,
        PictureFileException => "raycaster: " + e.Message,
        IOException or UnauthorizedAccessException => "raycaster: " + (IsCurrentFolderThere() ? e.Message : "the current folder was deleted"),
        _ => IsOutOfMemory(e) ? "raycaster: there is not enough memory" : null,
    };

    private static int Report(Exception unexpected)
    {
        StandardFile.WriteError($"""
            {Fault.InWords("raycaster", unexpected)}
            With RAYCASTER_TRACE=1 it shows where it happened.

            """);
        if (Environment.GetEnvironmentVariable("RAYCASTER_TRACE") == "1")
            StandardFile.WriteError(unexpected.StackTrace + Environment.NewLine);
        return ExitCode.InternalError;
    }

    private static bool IsCurrentFolderThere()
    {
        try
        {
            return Environment.CurrentDirectory.Length > 0;
        }
        catch (IOException)
        {
            return false;
        }
    }

    /// <summary>Whether memory ran out, on any thread.</summary>
    private static bool IsOutOfMemory(Exception? e) =>
        e is OutOfMemoryException || (e is AggregateException or TypeInitializationException && IsOutOfMemory(e.InnerException));

    private static int Run(string[] arguments, CancellationToken cancellation)
    {
        if (arguments.Length == 0)
        {
            StandardFile.WriteError(HelpText.Usage);
            return ExitCode.CouldNot;
        }
        var line = CommandLine.Parse(arguments);
        if (line.Has(Option.Help))
        {
            StandardFile.WriteOutput(line.Command.Help);
            return ExitCode.Done;
        }
        if (line.Has(Option.Version))
        {
            StandardFile.WriteOutput(typeof(Program).Assembly.GetName().Version!.ToString(3) + Environment.NewLine);
            return ExitCode.Done;
        }
        return line.Command.Run(line, cancellation);
    }
}
