using System.Runtime.InteropServices;

namespace RayCaster.Cli;

internal static class Program
{
    private static int Main(string[] arguments)
    {
        using var cancellation = new CancellationTokenSource();
        var exitCode = ExitCode.Interrupted;
        void Cancel(PosixSignalContext context)
        {
            context.Cancel = true; // not the default, which would leave the temporary file behind
            exitCode = context.Signal switch
            {
                PosixSignal.SIGHUP => ExitCode.HungUp,
                PosixSignal.SIGTERM => ExitCode.Terminated,
                _ => ExitCode.Interrupted,
            };
            cancellation.Cancel();
        }
        using var interrupt = PosixSignalRegistration.Create(PosixSignal.SIGINT, Cancel);
        using var hangUp = PosixSignalRegistration.Create(PosixSignal.SIGHUP, Cancel); // the terminal's window was closed
        using var terminate = PosixSignalRegistration.Create(PosixSignal.SIGTERM, Cancel);

        try
        {
            return Run(arguments, cancellation.Token);
        }
        catch (OperationCanceledException) when (cancellation.IsCancellationRequested)
        {
            return exitCode;
        }
        catch (ProblemException problem)
        {
            StandardFile.WriteError(problem.Message + Environment.NewLine);
            return ExitCode.CouldNot;
        }
        catch (PictureFileException problem)
        {
            StandardFile.WriteError($"raycaster: {problem.Message}{Environment.NewLine}");
            return ExitCode.CouldNot;
        }
        catch (Exception unexpected)
        {
            StandardFile.WriteError($"""
                raycaster: internal error: {unexpected.Message}
                This is a fault of raycaster, please report it; with RAYCASTER_TRACE=1 it shows where it happened.

                """);
            if (Environment.GetEnvironmentVariable("RAYCASTER_TRACE") == "1")
                StandardFile.WriteError(unexpected.StackTrace + Environment.NewLine);
            return ExitCode.InternalError;
        }
    }

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
