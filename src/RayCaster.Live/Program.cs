using System.Diagnostics;
using System.Runtime.InteropServices;
using RayCaster.Cli;

namespace RayCaster.Live;

internal static class Program
{
    private static async Task<int> Main(string[] arguments)
    {
        Renderer.Disagreed = difference => Console.Error.WriteLine($"The engine disagrees with ScalarRenderer, which draws again: {difference}");
        // The process ends with this method, even with open pages: they hold nothing that could be lost.
        var end = new TaskCompletionSource<int>(TaskCreationOptions.RunContinuationsAsynchronously);
        using var interrupt = PosixSignalRegistration.Create(PosixSignal.SIGINT, context => End(context, ExitCode.Interrupted));
        using var terminate = PosixSignalRegistration.Create(PosixSignal.SIGTERM, context => End(context, ExitCode.Terminated));
        try
        {
            if (LiveOptions.Parse(arguments) is not { } options)
            {
                Console.Out.WriteLine(LiveHelp.Text);
                return ExitCode.Done;
            }
            // The page shows a scene's mistakes; a file that does not exist is a mistake on the command line.
            if (!File.Exists(options.Scene))
            {
                Console.Error.Write(SceneReader.Read(options.Scene).Report());
                return ExitCode.CouldNot;
            }
            var server = await LiveServer.StartAsync(options);
            Console.Out.WriteLine(Greeting(options, server));
            if (options.OpensBrowser && !DotnetWatch.IsRestart) Open(server.Address);
            return await end.Task;
        }
        catch (ProblemException problem)
        {
            Console.Error.WriteLine($"raycaster-live: {problem.Message}");
            if (problem.IsUsage) Console.Error.WriteLine("Try dotnet run --project src/RayCaster.Live -- --help.");
            return ExitCode.CouldNot;
        }
        catch (Exception unexpected)
        {
            Console.Error.WriteLine(Fault.InWords("raycaster-live", unexpected));
            return ExitCode.InternalError;
        }

        void End(PosixSignalContext context, int exitCode)
        {
            context.Cancel = true;
            end.TrySetResult(exitCode);
        }
    }

    private static string Greeting(LiveOptions options, LiveServer server) => $"""
        The page for {options.Scene} is at
          {server.Address}
        It draws the scene again when you save the file. Press Ctrl-C to end it.
        From another machine: ssh -L {server.Port}:127.0.0.1:{server.Port} USER@THIS-MACHINE, then open the address there.
        """;

    /// <summary>Opens a browser if there is a screen. The address is on the terminal in any case.</summary>
    private static void Open(string address)
    {
        var hasScreen = OperatingSystem.IsWindows() || OperatingSystem.IsMacOS()
            || Environment.GetEnvironmentVariable("DISPLAY") is { Length: > 0 }
            || Environment.GetEnvironmentVariable("WAYLAND_DISPLAY") is { Length: > 0 };
        if (!hasScreen) return;
        try
        {
            var start = OperatingSystem.IsWindows() ? new ProcessStartInfo(address) { UseShellExecute = true }
                : new ProcessStartInfo(OperatingSystem.IsMacOS() ? "open" : "xdg-open", address) { RedirectStandardError = true };
            Process.Start(start)?.Dispose();
        }
        catch (Exception e) when (e is System.ComponentModel.Win32Exception or InvalidOperationException)
        {
            // This machine has no program that opens addresses.
        }
    }
}
