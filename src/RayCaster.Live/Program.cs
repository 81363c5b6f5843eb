using System.Diagnostics;
using System.Runtime.InteropServices;

namespace RayCaster.Live;

internal static class Program
{
    private const int CouldNot = 2, InternalError = 70, Interrupted = 130, Terminated = 143;

    private static async Task<int> Main(string[] arguments)
    {
        // The process ends as soon as this method does: pages that are open keep nothing that could be lost.
        var end = new TaskCompletionSource<int>(TaskCreationOptions.RunContinuationsAsynchronously);
        using var interrupt = PosixSignalRegistration.Create(PosixSignal.SIGINT, context => End(context, Interrupted));
        using var terminate = PosixSignalRegistration.Create(PosixSignal.SIGTERM, context => End(context, Terminated));
        try
        {
            var options = LiveOptions.Parse(arguments);
            if (options.WantsHelp)
            {
                Console.Out.Write(LiveOptions.Help);
                return 0;
            }
            if (!File.Exists(options.Scene)) // a scene with mistakes is shown with them, but what is not there is a mistake of the command line
                throw new ProblemException(SceneReader.Read(options.Scene).Report().TrimEnd());
            var server = await LiveServer.StartAsync(options);
            Console.Out.WriteLine(Greeting(options, server));
            if (options.OpensBrowser && !WatchLine.IsRestart) Open(server.Address);
            return await end.Task;
        }
        catch (ProblemException problem)
        {
            Console.Error.WriteLine(problem.Message);
            return CouldNot;
        }
        catch (Exception unexpected)
        {
            Console.Error.WriteLine($"raycaster-live: internal error: {unexpected.Message}\nThis is a fault of raycaster, please report it.");
            return InternalError;
        }

        void End(PosixSignalContext context, int exitCode)
        {
            context.Cancel = true;
            end.TrySetResult(exitCode);
        }
    }

    private static string Greeting(LiveOptions options, LiveServer server) => $"""
        {options.Scene} is shown at
          {server.Address}
        Save the file, and the picture follows. Ctrl-C ends it.
        From another machine: ssh -L {server.Port}:127.0.0.1:{server.Port} USER@THIS-MACHINE, then open the address there.
        """;

    /// <summary>Opens a browser where there is a screen; where none comes up the address is on the terminal.</summary>
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
            // No program opens addresses here.
        }
    }
}
