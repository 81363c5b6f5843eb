using System.Runtime.InteropServices;

namespace RayCaster.Cli;

internal static class Program
{
    /// <summary>The signal for a file that is larger than "ulimit -f" allows; the same number on Linux and macOS.</summary>
    private const PosixSignal FileTooLarge = (PosixSignal)25;

    private const int Glance = 50, Moment = 200; // milliseconds

    private static PosixSignalRegistration? tooLarge; // until the end: the signal may come at any time

    internal static int Main(string[] arguments)
    {
        using var cancellation = new CancellationTokenSource();
        var codeOfSignal = ExitCode.Interrupted;
        void Cancel(PosixSignalContext context)
        {
            context.Cancel = true; // the default would end the process and leave the temporary file
            codeOfSignal = context.Signal switch
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
        // By default it ends the process. Ignored, the write fails with a message.
        if (!OperatingSystem.IsWindows()) tooLarge ??= PosixSignalRegistration.Create(FileTooLarge, context => context.Cancel = true);

        // A thread of its own, so that work that does not end soon after a signal can be left unfinished. The first use of the thread pool would
        // cost each run some milliseconds.
        int? exitCode = null;
        var work = new Thread(() => exitCode = Run(arguments, cancellation.Token)) { IsBackground = true };
        work.Start();
        while (!cancellation.IsCancellationRequested && !work.Join(Glance)) ;
        work.Join(Moment);
        if (exitCode is { } code) return code;
        Interruption.Tell(arguments);
        return codeOfSignal;
    }

    /// <summary>Runs a command line, and tells what keeps it from being done.</summary>
    /// <returns>The exit code; null if the run was cancelled.</returns>
    private static int? Run(string[] arguments, CancellationToken cancellation)
    {
        try
        {
            return Answer(arguments, cancellation);
        }
        catch (Exception) when (cancellation.IsCancellationRequested) // after a cancellation, writing may fail because the terminal is gone
        {
            return null;
        }
        catch (Exception e) when (Message(e) is { } message)
        {
            StandardFile.WriteError($"raycaster: {message}");
            if (e is ProblemException { IsUsage: true }) StandardFile.WriteError(HelpCommand.HintAfter(arguments));
            return ExitCode.CouldNot;
        }
        catch (Exception unexpected)
        {
            StandardFile.WriteError($"""
                {Fault.InWords("raycaster", unexpected)}
                With RAYCASTER_TRACE=1 it shows where it happened.
                """);
            if (Environment.GetEnvironmentVariable("RAYCASTER_TRACE") == "1")
                StandardFile.WriteError($"{unexpected.StackTrace}");
            return ExitCode.InternalError;
        }
    }

    private static int Answer(string[] arguments, CancellationToken cancellation)
    {
        if (arguments.Length == 0)
        {
            StandardFile.WriteError(HelpCommand.Usage);
            return ExitCode.CouldNot;
        }
        var line = CommandLine.Parse(arguments);
        if (line.Has(Option.Help))
            StandardFile.WriteOutput(line.Command.Help);
        else if (line.Has(Option.Version))
            StandardFile.WriteOutput(typeof(Program).Assembly.GetName().Version!.ToString(3));
        else
            return line.Command.Run(line, cancellation);
        return ExitCode.Done;
    }

    /// <summary>What to tell the user; null for a fault of this program.</summary>
    private static string? Message(Exception e) => e switch
    {
        ProblemException => e.Message,
        IOException or UnauthorizedAccessException => IsCurrentFolderThere() ? e.Message : "the current folder was deleted",
        _ => IsOutOfMemory(e) ? "there is not enough memory" : null,
    };

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
}
