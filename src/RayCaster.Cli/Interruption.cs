using System.Runtime.InteropServices;

namespace RayCaster.Cli;

/// <summary>Ends a command's work on a signal, whatever it reads, waits for or computes.</summary>
internal static class Interruption
{
    /// <summary>The signals for more processor time than "ulimit -t" allows, and for a larger file than "ulimit -f" does; the same numbers on Linux
    /// and macOS.</summary>
    private const PosixSignal TooMuchTime = (PosixSignal)24, FileTooLarge = (PosixSignal)25;

    private static readonly TimeSpan PollInterval = TimeSpan.FromMilliseconds(50);
    private static readonly TimeSpan WorkGracePeriod = TimeSpan.FromMilliseconds(200), MessageGracePeriod = TimeSpan.FromSeconds(0.5);

    private static PosixSignalRegistration? tooLarge; // until the end: the signal may come at any time

    /// <summary>Runs a command's work on a thread of its own, so that work that does not end soon after a signal can be left unfinished.</summary>
    /// <param name="work">Returns the exit code.</param>
    public static int Run(Command command, Func<CancellationToken, int> work)
    {
        using var cancellation = new CancellationTokenSource();
        var codeOfSignal = ExitCode.Interrupted;
        using var interrupt = PosixSignalRegistration.Create(PosixSignal.SIGINT, Cancel);
        using var hangUp = PosixSignalRegistration.Create(PosixSignal.SIGHUP, Cancel); // the terminal window was closed
        using var terminate = PosixSignalRegistration.Create(PosixSignal.SIGTERM, Cancel);
        using var tooMuchTime = OperatingSystem.IsWindows() ? null : PosixSignalRegistration.Create(TooMuchTime, Cancel);
        // By default it ends the process. Ignored, the write fails with a message.
        if (!OperatingSystem.IsWindows()) tooLarge ??= PosixSignalRegistration.Create(FileTooLarge, context => context.Cancel = true);

        int? exitCode = null;
        var thread = new Thread(Work) { IsBackground = true };
        thread.Start();
        while (!cancellation.IsCancellationRequested && !thread.Join(PollInterval)) ;
        thread.Join(WorkGracePeriod);
        if (exitCode is { } code) return code;
        WrittenFiles.Abort(); // deletes unfinished files
        Tell(command);
        return codeOfSignal;

        void Work()
        {
            try
            {
                exitCode = work(cancellation.Token);
            }
            catch (Exception) when (cancellation.IsCancellationRequested)
            {
            }
        }

        void Cancel(PosixSignalContext context)
        {
            context.Cancel = true; // the default would end the process and leave the temporary file
            codeOfSignal = context.Signal switch
            {
                PosixSignal.SIGHUP => ExitCode.HungUp,
                PosixSignal.SIGTERM => ExitCode.Terminated,
                TooMuchTime => ExitCode.OutOfTime,
                _ => ExitCode.Interrupted,
            };
            cancellation.Cancel();
        }
    }

    /// <summary>Says in one line what was finished, and how to continue. Does not wait if standard error is a pipe that no program reads.</summary>
    private static void Tell(Command command)
    {
        var resumes = WrittenFiles.Count > 0 && command.Options.Contains(PartCommand.Resume);
        var end = command is LiveCommand ? "the page's server has stopped" : $"{Written()}{(resumes ? "; --resume continues" : "")}";
        var telling = new Thread(() => StandardStreams.WriteError($"raycaster: interrupted; {end}")) { IsBackground = true };
        telling.Start();
        telling.Join(MessageGracePeriod);
    }

    private static string Written() => (WrittenFiles.Count, WrittenFiles.Last) switch
    {
        (0, _) when StandardStreams.HasOutput => "standard output is incomplete",
        (0, _) => "nothing was written",
        (1, var file) => $"{file} was written before",
        var (count, last) => $"{count} files were written before, the last is {last}",
    };
}
