namespace RayCaster.Cli;

internal sealed class CheckCommand : Command
{
    public override string Help => """
        Description:
          Finds errors in scene files without casting a ray. Then says how good the scenes are as
          tests: which mistakes of a ray caster their pictures cannot show or cannot distinguish,
          how many pixels depend on the last bits, and what to change. Several scenes are judged
          as a set.

        Usage:
          raycaster check <scene>... [options]

        Arguments:
          <scene>  A scene file; "-" reads it from standard input.

        Options:
              --for <shapes>   Only mistakes of programs that draw just these shapes, for example
                               plane,sphere. The shapes: plane, sphere, aabb, circle, triangle, mesh.
              --require <ids>  Mistakes that must show, for example rows,bgr: if one does not, the
                               exit code is 1.
              --all            Tries every mistake, however long it takes. Otherwise those are left
                               out that 10 s of processor time do not suffice for.
              --json           The answer as JSON, also the errors of scenes.
          -q, --quiet          Errors and warnings only.
          -t, --threads <n>    How many threads draw. [default: one per core]

        Examples:
          dotnet run --project src/RayCaster.Cli -- check scenes/room.json
          dotnet run --project src/RayCaster.Cli -- check scenes/mistakes/*.json

        Exit codes:
          0 no error, 1 a scene has errors or does not show a required mistake, 2 failed.
        """;

    public override int Run(CommandLine line, CancellationToken cancellation)
    {
        if (line.Operands.Count == 0) throw ProblemException.Usage("check takes <scene>..., but nothing is given");
        var (threads, json, quiet) = (line.ThreadCount(), line.Has(Option.Json), line.Has(Option.Quiet));
        var required = line.Names(Option.Require, ',', MistakeOutput.Ids, "a mistake");
        var shapes = line.Names(Option.For, ',', SceneReader.ModelTypes, "a kind of shape");
        var (scenes, errors) = (new List<Scene>(), new List<Problem>());
        var exitCode = ExitCode.Done;
        foreach (var path in line.Operands)
        {
            cancellation.ThrowIfCancellationRequested();
            var reading = SceneInput.Read(path, line, judges: true);
            if (json) StandardStreams.WriteError(reading.Report());
            else StandardStreams.WriteOutput(reading.Report());
            errors.AddRange(reading.Problems.Where(problem => problem.IsError));
            if (reading.Scene is { } scene) scenes.Add(scene);
            else exitCode = Math.Max(exitCode, reading.IsUnread ? ExitCode.CouldNot : ExitCode.No);
        }
        if (exitCode != ExitCode.Done && json) StandardStreams.WriteOutput(FitnessReport.Json(errors));
        if (exitCode != ExitCode.Done || (quiet && !json && required.Length == 0)) return exitCode;

        if (!json && !quiet)
            StandardStreams.WriteOutput((scenes.Count == 1 ? line.Operands[0] : $"{scenes.Count} scenes") + ": no errors.");
        if (!scenes.TrueForAll(SceneFitness.CanJudge))
            throw new ProblemException($"a scene has more than {SceneFitness.MaxModels:N0} models: too many to try mistakes on");
        var fitness = SceneFitness.Of(scenes, threads,
            [.. MistakeCatalog.All.Where(mistake => shapes.Length == 0 || mistake.Touches(shapes))], line.Budget());
        var absent = required.Where(id => fitness.Asked.All(mistake => mistake.Id != id)
            || fitness.Hidden.Concat(fitness.NotTried).Any(mistake => mistake.Id == id)).ToArray();
        if (json) StandardStreams.WriteOutput(FitnessReport.Json(fitness, absent, line.Warning));
        else if (!quiet) StandardStreams.WriteOutput(FitnessReport.Text(fitness));
        if (absent.Length == 0) return ExitCode.Done;
        StandardStreams.WriteError($"required, but not shown: {string.Join(", ", absent)}");
        return ExitCode.No;
    }
}
