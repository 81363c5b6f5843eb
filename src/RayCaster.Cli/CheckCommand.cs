namespace RayCaster.Cli;

/// <summary>Says what is wrong with scene files, and what they are fit for as tests.</summary>
internal sealed class CheckCommand : Command
{
    public override Option[] Options { get; } = [Option.Threads, Option.Quiet];

    public override string Help => """
        Description:
          Finds the errors of scene files without casting a ray, and then says what the scenes are
          fit for as tests: which mistakes of a ray caster their pictures cannot show, which they
          cannot tell apart, how many pixels depend on the last bits, and what to change. Several
          scenes are judged as a set.

        Usage:
          raycaster check <scene>... [options]

        Arguments:
          <scene>  A scene file; "-" reads it from standard input.

        Options:
          -q, --quiet          Errors and warnings only.
          -t, --threads <n>    How many threads draw. [default: one per core]

        Examples:
          dotnet run --project src/RayCaster.Cli -- check scenes/room.json
          dotnet run --project src/RayCaster.Cli -- check scenes/mistakes/*.json

        Exit codes:
          0 no error, 1 a scene has errors, 2 could not read one.

        """;

    public override int Run(CommandLine line, CancellationToken cancellation)
    {
        if (line.Operands.Count == 0) throw ProblemException.Usage("check takes <scene>..., but nothing is given");
        var threads = line.ThreadCount();
        var scenes = new List<Scene>();
        var exitCode = ExitCode.Done;
        foreach (var path in line.Operands)
        {
            cancellation.ThrowIfCancellationRequested();
            var reading = SceneInput.Read(path, threads);
            if (reading.Scene is { } scene) scenes.Add(scene);
            var unread = reading.Problems.Any(problem => problem.IsError && problem.Line == 0);
            StandardFile.WriteOutput(reading.Report());
            if (reading.Scene is null) exitCode = Math.Max(exitCode, unread ? ExitCode.CouldNot : ExitCode.No);
        }
        if (exitCode != ExitCode.Done || line.Has(Option.Quiet)) return exitCode;

        var head = scenes.Count == 1 ? $"{line.Operands[0]}: no errors." : $"{scenes.Count} scenes: no errors.";
        StandardFile.WriteOutput(head + Environment.NewLine);
        if (!scenes.TrueForAll(SceneFitness.CanJudge))
        {
            StandardFile.WriteOutput($"A scene has more than {SceneFitness.MostModels} models: too many to try mistakes on." + Environment.NewLine);
            return exitCode;
        }
        var fitness = SceneFitness.Of(scenes, threads);
        StandardFile.WriteOutput(FitnessReport.Text(fitness));
        return exitCode;
    }
}
