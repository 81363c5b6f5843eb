using System.ComponentModel;

namespace RayCaster.Cli;

/// <summary>Starts the live page. It is a separate program, because a web server would make this one start more slowly.</summary>
internal sealed class LiveCommand() : Command("live", "<scene>", "Opens a page that redraws the scene when you save it.")
{
    private static readonly TimeSpan pollInterval = TimeSpan.FromMilliseconds(50);

    public override string Description =>
        "Opens a page on this machine that shows a scene's picture and draws it again when you save the scene file. Drag to turn the camera; " +
        "click a pixel to read how it got its colour. In a clone \"dotnet run --project src/RayCaster.Live -- <scene>\" does the same.";

    public override IReadOnlyList<(string, string)> Arguments => [("<scene>", "The scene file (JSON).")];

    public override IReadOnlyList<Option> Options => LiveOptions.All;

    public override string[] Examples => ["live scenes/room.json"];

    public override int Run(CommandLine line, CancellationToken cancellation)
    {
        line.Exactly("<scene>");
        using var live = Start([LiveOptions.UntilInputEnds.Name, .. line.Words]); // however this process ends, the system then closes the pipe
        while (!live.WaitForExit(pollInterval)) cancellation.ThrowIfCancellationRequested();
        return live.ExitCode;
    }

    private static Process Start(string[] arguments)
    {
        var start = LiveProgram.Beside() is { } program ? new ProcessStartInfo("dotnet", [program, .. arguments])
            : LiveProgram.Project() is { } project ? new("dotnet", ["run", "--project", project, "--", .. arguments])
            : throw new ProblemException($"the live page is a program of its own, {LiveProgram.Name}, which is not in {AppContext.BaseDirectory}\n" +
                "  In a clone of the project: dotnet run --project src/RayCaster.Live -- <scene>");
        try
        {
            start.RedirectStandardInput = true;
            return Process.Start(start)!;
        }
        catch (Win32Exception e)
        {
            throw new ProblemException($"{start.FileName} cannot be started: {e.Message}");
        }
    }
}
