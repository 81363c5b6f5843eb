namespace RayCaster.Cli;

/// <summary>Starts the live page. It is a separate program, because a web server would make this one start more slowly.</summary>
internal sealed class LiveCommand() : Command("live", "<scene>", "Opens a page that redraws the scene when you save it.")
{
    internal const string Program = "raycaster-live.dll";

    public override string Description =>
        "Opens a page on this machine that shows a scene's picture and draws it again when you save the scene file. Drag to turn the camera; " +
        "click a pixel to read how it got its colour. In a clone \"dotnet run --project src/RayCaster.Live -- <scene>\" does the same.";

    public override IReadOnlyList<(string, string)> Arguments => [("<scene>", "The scene file (JSON).")];

    public override IReadOnlyList<Option> Options => LiveOptions.All;

    public override string[] Examples => ["live scenes/room.json"];

    public override int Run(CommandLine line)
    {
        line.Exactly("<scene>");
        var folder = ProgramFolder() ?? throw new ProblemException(
            $"the live page is a program of its own, {Program}, which is not in {AppContext.BaseDirectory}\n" +
            "  In a clone of the project: dotnet run --project src/RayCaster.Live -- <scene>");
        return Programs.Run([Path.Combine(folder, Program), LiveOptions.UntilInputEnds.Name, .. line.Words]);
    }

    /// <summary>The folder of the page's program: this one's if it was installed, and in a hand-out; in a clone it is built. Null if there is
    /// none.</summary>
    internal static string? ProgramFolder() =>
        File.Exists(Path.Combine(AppContext.BaseDirectory, Program)) ? AppContext.BaseDirectory
        : FilePlace.FolderWith("RayCaster.sln") is { } clone ? Programs.Build(Path.Combine(clone, "src", "RayCaster.Live")) : null;
}
