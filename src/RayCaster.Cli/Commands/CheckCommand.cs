namespace RayCaster.Cli;

internal sealed class CheckCommand() : Command("check", "<scene>...", "Finds errors, and mistakes that a scene cannot show.")
{
    private static readonly Option<string[]> shapes = Option.List("--for", "<shapes>",
        "Only mistakes of programs that draw just these shapes, for example plane,sphere. " +
        $"The shapes: {string.Join(", ", SceneReader.ModelTypes)}.", SceneReader.ModelTypes);
    private static readonly Option<string[]> require = Option.List("--require", "<ids>",
        "Mistakes that must show, for example rows,bgr: if one does not, the exit code is 1.", WrongCommand.Ids);

    public override string Description =>
        "Finds errors in scene files without casting a ray. Then says how good the scenes are as tests: which mistakes of a ray caster their " +
        "pictures cannot show or cannot distinguish, how many pixels depend on the last bits, and what to change. Several scenes are judged " +
        "as a set.";

    public override IReadOnlyList<(string, string)> Arguments =>
        [("<scene>...", "Scene files, or patterns like \"scenes/weeks/*.json\"; \"-\" reads a scene from standard input.")];

    public override Option[] Options => [shapes, require, Option.Everything, Option.Quiet, Option.Threads];

    public override string[] Examples => ["check scenes/room.json", "check scenes/mistakes/*.json"];

    public override string ExitCodes => "0 no error, 1 a scene has errors or does not show a required mistake, 2 failed.";

    public override int Run(CommandLine line)
    {
        if (line.Operands.Count == 0) throw ProblemException.Usage("check takes <scene>..., but nothing is given");
        var quiet = line.Get(Option.Quiet);
        var required = line.Get(require) ?? [];
        var files = Glob.Expand(line.Operands);
        var scenes = new List<Scene>();
        var exitCode = ExitCode.Done;
        foreach (var path in files)
        {
            var reading = SceneInput.TryRead(path, line, judges: true);
            StandardStreams.WriteOutput(reading.Report());
            if (reading.Scene is { } scene) scenes.Add(scene);
            else exitCode = Math.Max(exitCode, reading.IsUnread ? ExitCode.Failed : ExitCode.No);
        }
        if (exitCode != ExitCode.Done || (quiet && required.Length == 0)) return exitCode;

        if (!quiet)
            StandardStreams.WriteOutput((scenes.Count == 1 ? files[0] : $"{scenes.Count} scenes") + ": no errors.");
        if (!scenes.TrueForAll(MutationCoverage.CanJudge))
            throw new ProblemException($"a scene has more than {MutationCoverage.MaxModels:N0} models: too many to try mistakes on");
        var mistakes = MistakeCatalog.All.Where(mistake => line.Get(shapes) is not { } some || mistake.Touches(some));
        var coverage = MutationCoverage.Measure(scenes, line.Get(Option.Threads), [.. mistakes], line.Budget());
        var absent = required.Where(id => coverage.Tested.All(mistake => mistake.Id != id)
            || coverage.Hidden.Concat(coverage.NotTried).Any(mistake => mistake.Id == id)).ToArray();
        if (!quiet) StandardStreams.WriteOutput(CoverageReport.Text(coverage));
        if (absent.Length == 0) return ExitCode.Done;
        StandardStreams.WriteError($"required, but not shown: {string.Join(", ", absent)}");
        return ExitCode.No;
    }
}
