namespace RayCaster.Cli;

internal sealed class VaryCommand : Command
{
    public override string Help => """
        Description:
          Changes the numbers of a scene a little, so that each student gets a different scene.
          It looks similar, and vary checks that it shows the same mistakes. Comments and layout
          of the file stay.

        Usage:
          raycaster vary <scene> --seed <text> -o <file>

        Arguments:
          <scene>  The scene file.

        Options:
              --seed <text>    For example a student's number. The same seed gives the same scene.
          -o, --output <file>  Where to write the scene. If it names mesh files: in the same folder.
              --all            Tries every mistake, however long it takes. Otherwise those are left
                               out that 10 s of processor time do not suffice for.
          -q, --quiet          Prints errors only.

        Examples, where raycaster is "dotnet run --project src/RayCaster.Cli --":
          raycaster vary scenes/weeks/4-all.json --seed 12345 -o scenes/my/12345.json

        Exit codes:
          0 done, 1 the scene has errors, or no variation shows the same mistakes, 2 failed.
        """;

    public override int Run(CommandLine line, CancellationToken cancellation)
    {
        var path = line.Exactly("<scene>")[0];
        if (line[Option.Seed] is not { Length: > 0 } seed) throw ProblemException.Usage("vary needs a seed, as in --seed 12345");
        if (line[Option.Output] is not { } output) throw ProblemException.Usage("vary needs a name for the scene, as in -o mine.json");
        var reading = SceneInput.Read(path, line, judges: true);
        StandardStreams.WriteError(reading.Report());
        if (reading.Scene is not { } scene) return reading.IsUnread ? ExitCode.CouldNot : ExitCode.No;

        var folder = Path.GetDirectoryName(Path.GetFullPath(path))!;
        var newFolder = Path.GetDirectoryName(Path.GetFullPath(output))!;
        if (scene.Models.Any(model => model is Mesh) && newFolder != folder)
            throw new ProblemException($"{path} names mesh files, whose paths start at its folder: " +
                $"write {Path.GetFileName(output)} to {folder}");
        var budget = line.Budget();
        if (SceneVariation.Of(reading.Text, folder, seed, newFolder, budget) is not { } varied)
        {
            StandardStreams.WriteError($"{path}: no variation of it shows all its mistakes; try another seed");
            return ExitCode.No;
        }
        PictureOutput.Write(output, cancellation, stream => stream.Write(varied));
        line.Tell($"{PictureOutput.NameOf(output)}: {path}, varied; it shows the same mistakes" +
            (budget?.LeavesOut == true ? ", of those that were tried within 10 s; --all tries all" : ""));
        return ExitCode.Done;
    }
}
