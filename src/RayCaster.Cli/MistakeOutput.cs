namespace RayCaster.Cli;

/// <summary>Drawing with --mistake: the picture of a wrong program, for exams and for testing a rubric.</summary>
internal static class MistakeOutput
{
    /// <summary>Reads the scene, draws it with the mistakes, and writes the picture.</summary>
    public static int Run(CommandLine line, string path, CancellationToken cancellation)
    {
        var mistakes = NameList.Of(line[Option.Mistake]!, '+', [.. MistakeCatalog.All.Select(mistake => mistake.Id)], "a mistake")
            .Select(id => MistakeCatalog.Named(id)!).ToArray();
        var output = line[Option.Output] ?? $"{DrawCommand.NameOf(path)}.{string.Join('+', mistakes.Select(mistake => mistake.Id))}.png";
        var format = PictureOutput.FormatOf(line, output);
        PictureOutput.KeepOffTerminal(output);
        if (SceneInput.Read(path, line, cancellation) is not { } scene) return ExitCode.CouldNot;
        SceneInput.WarnOfChangedFormulas(path, scene);

        var picture = MistakeCatalog.Draw(scene, mistakes, line.ThreadCount());
        PictureOutput.Write(output, picture, format, cancellation);
        line.Tell($"{PictureOutput.NameOf(output)}: wrong on purpose: {string.Join("; ", mistakes.Select(mistake => mistake.Cause))}");
        return ExitCode.Done;
    }
}
