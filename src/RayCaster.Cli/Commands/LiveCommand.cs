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
        return Programs.Run([Path.Join(ProgramFolder(), Program), LiveOptions.UntilInputEnds.Name, .. line.Words]);
    }

    /// <summary>The folder of the page's program: this one's if it was installed, and in a hand-out; in a clone that of its project, if it was built
    /// with the same assemblies.</summary>
    /// <exception cref="ProblemException">It is nowhere; the message says how to get it.</exception>
    internal static string ProgramFolder()
    {
        var here = Path.TrimEndingDirectorySeparator(AppContext.BaseDirectory);
        if (File.Exists(Path.Join(here, Program))) return here;
        var (framework, configuration) = (Path.GetFileName(here), Path.GetFileName(Path.GetDirectoryName(here)));
        if (FilePlace.FolderWith("RayCaster.sln") is not { } clone)
            throw new ProblemException($"the live page is a program of its own, {Program}, which is not beside this one\n" +
                $"  In a clone of the project: dotnet run --project src/RayCaster.Live -- <scene>");
        var built = Path.Join(clone, "src", "RayCaster.Live", "bin", configuration, framework);
        if (File.Exists(Path.Join(built, Program)) && Array.TrueForAll(CarriedTool.Assemblies, IsSame)) return built;
        throw new ProblemException($"the live page is a program of its own, which is not built with this one\n" +
            $"  Build it: dotnet build {Path.Join(clone, "src", "RayCaster.Live")} -c {configuration}");

        bool IsSame(string name) => File.Exists(Path.Join(built, name))
            && File.ReadAllBytes(Path.Join(built, name)).AsSpan().SequenceEqual(File.ReadAllBytes(Path.Join(here, name)));
    }
}
