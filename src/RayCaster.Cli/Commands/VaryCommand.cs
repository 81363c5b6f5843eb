namespace RayCaster.Cli;

internal sealed class VaryCommand() : Command("vary", "<scene>", "Makes a similar scene, one for each student.")
{
    private static readonly Option<string> seed = Option.Text("--seed", "<text>",
        "For example a student's number. The same seed gives the same scene.");
    private static readonly Option<string> output = Option.Text("-o, --output", "<file>",
        "Where to write the scene. If it names mesh files: in the same folder.");

    public override string Description =>
        "Changes the numbers of a scene a little, so that each student gets a different scene. It looks similar, and vary checks that it " +
        "shows the same mistakes. Comments and layout of the file stay.";

    public override IReadOnlyList<(string, string)> Arguments => [("<scene>", "The scene file.")];

    public override Option[] Options => [seed, output, Option.Everything, Option.Quiet];

    public override string[] Examples => ["vary scenes/weeks/4-all.json --seed 12345 -o scenes/my/12345.json"];

    public override string ExitCodes => "0 done, 1 the scene has errors, or no variation shows the same mistakes, 2 failed.";

    public override int Run(CommandLine line)
    {
        var path = line.Exactly("<scene>")[0];
        if (line.Get(seed) is not { } text) throw ProblemException.Usage("vary needs a seed, as in --seed 12345");
        if (line.Get(output) is not { } file) throw ProblemException.Usage("vary needs a name for the scene, as in -o mine.json");
        var reading = SceneInput.TryRead(path, line, judges: true);
        StandardStreams.WriteError(reading.Report());
        if (reading.Scene is not { } scene) return reading.IsUnread ? ExitCode.Failed : ExitCode.No;

        var folder = Path.GetDirectoryName(Path.GetFullPath(path))!;
        var newFolder = Path.GetDirectoryName(Path.GetFullPath(file))!;
        if (scene.Models.Any(model => model is Mesh) && Path.GetRelativePath(folder, newFolder) != ".")
            throw new ProblemException($"{path} names mesh files, whose paths start at its folder: " +
                $"write {Path.GetFileName(file)} to {folder}");
        var budget = line.Budget();
        if (SceneVariation.Create(reading.Text, folder, text, newFolder, budget) is not { } varied)
        {
            StandardStreams.WriteError($"{path}: no variation of it shows all its mistakes; try another seed");
            return ExitCode.No;
        }
        OutputFile.Write(file, varied);
        line.Tell($"{OutputFile.NameOf(file)}: {path}, varied; it shows the same mistakes" +
            (budget?.UsedUp is { } limit ? $", of those that were tried within {limit}; --all tries all" : ""));
        return ExitCode.Done;
    }
}
