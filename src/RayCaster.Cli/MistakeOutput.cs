namespace RayCaster.Cli;

/// <summary>Drawing with --mistake: the picture of a wrong program, for exams and for testing a rubric.</summary>
internal static class MistakeOutput
{
    /// <summary>Reads the scene, draws it with the mistakes, and writes the picture.</summary>
    public static int Run(CommandLine line, string path, CancellationToken cancellation)
    {
        var mistakes = NameList.Of(line[Option.Mistake]!, '+', [.. MistakeCatalog.All.Select(mistake => mistake.Id)], "a mistake")
            .Select(id => MistakeCatalog.Named(id)!).ToArray();
        var (size, threads, quiet) = (line.PictureSize(), line.ThreadCount(), line.Has(Option.Quiet));
        var output = line[Option.Output] ?? $"{DrawCommand.NameOf(path)}.{string.Join('+', mistakes.Select(mistake => mistake.Id))}.png";
        var format = line.PictureFormat()
            ?? (output == SceneInput.Standard ? PictureFormat.Ppm : PictureFormats.ByExtension(output));
        PictureOutput.KeepOffTerminal(output);
        if (SceneInput.Read(path, size, threads, quiet, cancellation) is not { } scene) return ExitCode.CouldNot;

        var picture = WrongPicture.Draw(scene, mistakes, threads);
        PictureOutput.Write(output, picture, format, cancellation);
        if (!quiet)
            StandardFile.WriteError($"{PictureOutput.NameOf(output)}: wrong on purpose: " +
                $"{string.Join("; ", mistakes.Select(mistake => mistake.Cause))}{Environment.NewLine}");
        return ExitCode.Done;
    }
}
