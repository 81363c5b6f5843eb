using System.Runtime.InteropServices;

namespace RayCaster.Cli;

/// <summary>Ends a command's work on a signal, whatever it reads, waits for or computes.</summary>
internal static class Interruption
{
    /// <summary>The signals for more processor time than "ulimit -t" allows, and for a larger file than "ulimit -f" does; the same numbers on Linux
    /// and macOS.</summary>
    private const PosixSignal TooMuchTime = (PosixSignal)24, FileTooLarge = (PosixSignal)25;

    private static PosixSignalRegistration? tooLarge; // until the end: the signal may come at any time

    /// <summary>Runs a command's work. A signal ends the process wherever the work is.</summary>
    /// <param name="report">Tells why the work failed, and returns the exit code.</param>
    public static int Run(Command command, Func<int> work, Func<Exception, int> report)
    {
        var end = 0; // 1 when the work is done, or when a signal has come: only the first of them ends the process
        using var interrupt = PosixSignalRegistration.Create(PosixSignal.SIGINT, End);
        using var hangUp = PosixSignalRegistration.Create(PosixSignal.SIGHUP, End); // the terminal window was closed
        using var terminate = PosixSignalRegistration.Create(PosixSignal.SIGTERM, End);
        using var tooMuchTime = OperatingSystem.IsWindows() ? null : PosixSignalRegistration.Create(TooMuchTime, End);
        // By default it ends the process. Ignored, the write fails with a message.
        if (!OperatingSystem.IsWindows()) tooLarge ??= PosixSignalRegistration.Create(FileTooLarge, context => context.Cancel = true);

        int exitCode;
        try
        {
            exitCode = work();
        }
        catch (Exception e)
        {
            // After a signal no file can be finished, and the terminal may be gone.
            exitCode = Volatile.Read(ref end) == 0 ? report(e) : ExitCode.Interrupted;
        }
        if (Interlocked.Exchange(ref end, 1) != 0) Thread.Sleep(Timeout.Infinite);
        return exitCode;

        void End(PosixSignalContext context)
        {
            context.Cancel = true; // the default would leave the temporary file
            if (Interlocked.Exchange(ref end, 1) != 0) return;
            AtomicFile.Abort(); // deletes unfinished files
            Tell(command);
            Environment.Exit(context.Signal switch
            {
                PosixSignal.SIGHUP => ExitCode.HungUp,
                PosixSignal.SIGTERM => ExitCode.Terminated,
                TooMuchTime => ExitCode.OutOfTime,
                _ => ExitCode.Interrupted,
            });
        }
    }

    /// <summary>Says in one line what was finished, and how to continue. Does not wait if standard error is a pipe that no program reads.</summary>
    private static void Tell(Command command)
    {
        var resumes = AtomicFile.Count > 0 && command.Options.Contains(PartCommand.Resume);
        var written = (AtomicFile.Count, AtomicFile.Last) switch
        {
            (0, _) when StandardStreams.HasOutput => "standard output is incomplete",
            (0, _) => "nothing was written",
            (1, var file) => $"{file} was written before",
            var (count, last) => $"{count} files were written before, the last is {last}",
        };
        var end = command is LiveCommand ? "the page's server has stopped" : $"{written}{(resumes ? "; --resume continues" : "")}";
        var telling = new Thread(() =>
        {
            ProgressLine.Wipe();
            StandardStreams.WriteError($"raycaster: interrupted; {end}");
        })
        { IsBackground = true };
        telling.Start();
        telling.Join(TimeSpan.FromSeconds(0.5));
    }
}
