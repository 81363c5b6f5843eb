using System.Runtime.InteropServices;

namespace RayCaster.Cli;

internal static class Program
{
    /// <summary>The signal for a file that is larger than "ulimit -f" allows; the same number on Linux and macOS.</summary>
    private const PosixSignal FileTooLarge = (PosixSignal)25;

    private static readonly TimeSpan PollInterval = TimeSpan.FromMilliseconds(50), GracePeriod = TimeSpan.FromMilliseconds(200);

    private static PosixSignalRegistration? tooLarge; // until the end: the signal may come at any time

    internal static int Main(string[] arguments)
    {
        try
        {
            return RunUntilSignal(arguments);
        }
        catch (TypeInitializationException e) when (e.InnerException is IOException) // of the runtime's handling of signals
        {
            StandardStreams.WriteError("raycaster: the system allows too few processes or open files: see ulimit -u and ulimit -n");
            return ExitCode.CouldNot;
        }
    }

    private static int RunUntilSignal(string[] arguments)
    {
        Console.OutputEncoding = Encoding.UTF8; // of a console of Windows; others have it already
        Renderer.Disagreed = difference =>
            StandardStreams.WriteError($"raycaster: the engine disagrees with ScalarRenderer, which draws again: {difference}");
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

        // A thread of its own, so that work that does not end soon after a signal can be left unfinished.
        int? exitCode = null;
        var work = new Thread(() => exitCode = Run(arguments, cancellation.Token)) { IsBackground = true };
        work.Start();
        while (!cancellation.IsCancellationRequested && !work.Join(PollInterval)) ;
        work.Join(GracePeriod);
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
            StandardStreams.WriteError($"raycaster: {message}");
            if (e is ProblemException { IsUsage: true }) StandardStreams.WriteError(HelpCommand.HintAfter(arguments));
            return ExitCode.CouldNot;
        }
        catch (Exception unexpected)
        {
            StandardStreams.WriteError($"""
                {Fault.InWords("raycaster", unexpected)}
                With RAYCASTER_TRACE=1 it shows where it happened.
                """);
            if (Environment.GetEnvironmentVariable("RAYCASTER_TRACE") == "1")
                StandardStreams.WriteError($"{unexpected.StackTrace}");
            return ExitCode.InternalError;
        }
    }

    private static int Answer(string[] arguments, CancellationToken cancellation)
    {
        if (arguments.Length == 0)
        {
            StandardStreams.WriteError(HelpCommand.Usage);
            return ExitCode.CouldNot;
        }
        var line = CommandLine.Parse(arguments);
        if (line.Has(Option.Help))
            StandardStreams.WriteOutput(line.Command.Help);
        else if (line.Has(Option.Version))
            StandardStreams.WriteOutput(typeof(Program).Assembly.GetName().Version!.ToString(3));
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
