namespace RayCaster.Cli;

/// <summary>Reads the scene of a command.</summary>
internal static class SceneInput
{
    /// <summary>The name for standard input and for standard output.</summary>
    public const string Standard = "-";

    /// <summary>Reads a scene and prints its errors and warnings.</summary>
    /// <param name="path">The file, or "-".</param>
    /// <returns>The scene; null if it has errors.</returns>
    public static Scene? Read(string path, CommandLine line, CancellationToken cancellation, bool warns = true)
    {
        var size = line.PictureSize();
        var (wide, high) = size ?? (0, 0); // the scene's own size is not known yet
        var reading = Read(path, line.ThreadCount(), text => WarmUp.Begin(text, (long)wide * high));
        cancellation.ThrowIfCancellationRequested();
        if (reading.Scene is null || (warns && !line.Has(Option.Quiet))) StandardFile.WriteError(reading.Report());
        if (reading.Scene is not { } scene || size is not var (width, height)) return reading.Scene;
        return scene with { Camera = scene.Camera.WithSize(width, height) };
    }

    /// <summary>Prints a warning if this build's picture of the scene differs from the stored reference: then it cannot judge other
    /// pictures.</summary>
    /// <returns>The warning; null if there is none.</returns>
    public static string? WarnOfChangedFormulas(string path, Scene scene)
    {
        if (path == Standard || StoredReference.Contradiction(path, scene) is not { } message) return null;
        var warning = $"{message}. What follows may be wrong.";
        StandardFile.WriteError(warning + Environment.NewLine);
        return warning;
    }

    /// <param name="threads">How many threads read a large mesh file; null for one per core.</param>
    /// <param name="look">Gets the text before it is parsed.</param>
    public static SceneReading Read(string path, int? threads, Action<ReadOnlySpan<byte>>? look = null)
    {
        var reading = path == Standard ? ReadStandardInput(threads, look) : SceneReader.Read(path, threads, look);
        InputFiles.Note([path, .. reading.MeshFiles]);
        return reading;
    }

    /// <remarks>A method of its own, because the runtime would load the console library wherever this is compiled.</remarks>
    private static SceneReading ReadStandardInput(int? threads, Action<ReadOnlySpan<byte>>? look)
    {
        if (StandardInput.IsClosed) throw new ProblemException("raycaster: the scene is to be read from standard input, but that is closed");
        using var input = Console.OpenStandardInput();
        return SceneReader.Read(input, "<stdin>", Environment.CurrentDirectory, threads, look);
    }
}
