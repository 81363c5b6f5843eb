using System.Runtime.InteropServices;

namespace RayCaster.Live;

internal static class Program
{
    private const string Usage = """
        Usage:
          dotnet run --project src/RayCaster.Live -- <scene> [--mine <file>] [--port <n>] [--no-browser]
        "raycaster help live" explains it. With --until-input-ends it ends when its standard input is closed.
        """;

    private static async Task<int> Main(string[] arguments)
    {
        StandardStreams.UseUtf8();
        // The process ends with this method, even with open pages: they hold nothing that could be lost.
        var end = new TaskCompletionSource<int>(TaskCreationOptions.RunContinuationsAsynchronously);
        using var interrupt = PosixSignalRegistration.Create(PosixSignal.SIGINT, context => End(context, ExitCode.Interrupted));
        using var terminate = PosixSignalRegistration.Create(PosixSignal.SIGTERM, context => End(context, ExitCode.Terminated));
        try
        {
            var line = CommandLine.Parse("live", [.. LiveOptions.All, LiveOptions.UntilInputEnds, LiveOptions.Silence, Option.Help], arguments);
            if (line.Get(Option.Help))
            {
                Console.Out.WriteLine(Usage);
                return ExitCode.Done;
            }
            var scene = line.Exactly("<scene>")[0];
            // The page shows a scene's errors; a file that does not exist is an error of the command line.
            if (!File.Exists(scene))
            {
                Console.Error.Write(SceneReader.Read(scene).Report());
                return ExitCode.Failed;
            }
            if (line.Get(LiveOptions.UntilInputEnds)) _ = Task.Run(EndWithInput);
            // It may wait for a mesh file for ever.
            var starting = Task.Run(() => LiveServer.StartAsync(
                scene, line.Get(LiveOptions.Mine), line.Get(LiveOptions.Port), silence: line.Get(LiveOptions.Silence) ?? 20));
            if (await Task.WhenAny(starting, end.Task) == end.Task) return await end.Task;
            var server = await starting;
            Console.Out.WriteLine(Greeting(scene, server));
            if (!line.Get(LiveOptions.NoBrowser) && !PageAddress.IsRestart && Browser.HasScreen)
                await Browser.OpenAsync(server.Address, server.Port, Task.WhenAny(end.Task, Task.Delay(TimeSpan.FromSeconds(30))));
            return await end.Task;
        }
        catch (ProblemException problem)
        {
            Console.Error.WriteLine($"raycaster-live: {problem.Message}");
            if (problem.IsUsage) Console.Error.WriteLine(Usage);
            return ExitCode.Failed;
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

        void EndWithInput()
        {
            Console.OpenStandardInput().CopyTo(Stream.Null);
            end.TrySetResult(ExitCode.Terminated);
        }
    }

    private static string Greeting(string scene, LiveServer server) => $"""
        The page for {scene} is at
          {server.Address}
        It draws the scene again when you save the file. Press Ctrl-C to end it.
        From another machine: ssh -L {server.Port}:127.0.0.1:{server.Port} USER@THIS-MACHINE, then open the address there.
        """;
}
