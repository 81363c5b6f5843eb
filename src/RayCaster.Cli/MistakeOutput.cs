namespace RayCaster.Cli;

/// <summary>Drawing with --mistake: the picture of a wrong program, for exams and for testing a rubric.</summary>
internal static class MistakeOutput
{
    public static IReadOnlyList<string> Ids => [.. MistakeCatalog.All.Select(mistake => mistake.Id)];

    public static int Run(CommandLine line, string path, CancellationToken cancellation)
    {
        var ids = line.Names(Option.Mistake, '+', Ids, "a mistake");
        var output = line[Option.Output] ?? $"{DrawCommand.NameOf(path)}.{string.Join('+', ids)}.png";
        var format = PictureOutput.FormatOf(line, output);
        if (SceneInput.Read(path, line, cancellation, judges: true) is not { } scene) return ExitCode.CouldNot;

        var mistakes = Array.ConvertAll(ids, id => MistakeCatalog.Named(id)!);
        var picture = MistakeCatalog.Draw(scene, mistakes, line.ThreadCount());
        PictureOutput.Write(output, picture, format, cancellation);
        line.Tell($"{PictureOutput.NameOf(output)}: wrong on purpose: {string.Join("; ", mistakes.Select(mistake => mistake.Cause))}");
        return ExitCode.Done;
    }
}
