namespace RayCaster.Cli;

/// <summary>Reads the scene of a command.</summary>
internal static class SceneInput
{
    /// <summary>The name for standard input and for standard output.</summary>
    public const string Standard = "-";

    /// <summary>Reads a scene and prints its errors and warnings.</summary>
    /// <param name="path">The file, or "-".</param>
    /// <returns>The scene; null if it has errors.</returns>
    /// <inheritdoc cref="Read(string, CommandLine, bool, Action{ReadOnlySpan{byte}}?)"/>
    public static Scene? Read(string path, CommandLine line, CancellationToken cancellation, bool warns = true, bool judges = false)
    {
        var (width, height) = line.PictureSize() ?? default; // 0: the scene's own, which is not known yet
        var reading = Read(path, line, judges, text => WarmUp.Begin(text, (long)width * height));
        cancellation.ThrowIfCancellationRequested();
        if (reading.Scene is null || (warns && !line.Has(Option.Quiet))) StandardFile.WriteError(reading.Report());
        return reading.Scene is { } scene && width > 0 ? scene.WithSize(width, height) : reading.Scene;
    }

    /// <summary>Reads a scene.</summary>
    /// <param name="judges">Whether the command judges pictures by this scene: warns if this build's picture of it differs from the stored
    /// reference.</param>
    /// <param name="look">Gets the text before it is parsed.</param>
    public static SceneReading Read(string path, CommandLine line, bool judges, Action<ReadOnlySpan<byte>>? look = null)
    {
        var reading = path == Standard ? ReadStandardInput(look) : SceneReader.Read(path, look);
        InputFiles.Note([path, .. reading.MeshFiles]);
        if (judges && path != Standard && reading.Scene is { } scene && StoredReference.Contradiction(path, scene) is { } message)
            line.Warn($"{message}. What follows may be wrong.");
        return reading;
    }

    /// <remarks>A method of its own, because the runtime would load the console library wherever this is compiled.</remarks>
    private static SceneReading ReadStandardInput(Action<ReadOnlySpan<byte>>? look)
    {
        if (StandardInput.IsClosed) throw new ProblemException("the scene is to be read from standard input, but that is closed");
        using var input = Console.OpenStandardInput();
        return SceneReader.Read(input, "<stdin>", Environment.CurrentDirectory, look);
    }
}
