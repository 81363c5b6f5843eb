namespace RayCaster.Cli;

/// <summary>The scene that a command is about.</summary>
internal static class SceneInput
{
    /// <summary>What stands for standard input, and for standard output.</summary>
    public const string Standard = "-";

    /// <summary>Reads a scene; prints what is wrong with it.</summary>
    /// <param name="path">The file, or "-".</param>
    /// <param name="size">The picture's size, if it is not to be the scene's.</param>
    /// <param name="threads">How many threads read a large mesh file; null for one per core.</param>
    /// <param name="quiet">Whether warnings are left out.</param>
    /// <param name="cancellation">Keeps what follows from beginning.</param>
    /// <returns>The scene, or null after its errors have been printed.</returns>
    public static Scene? Read(string path, (int Width, int Height)? size, int? threads, bool quiet, CancellationToken cancellation)
    {
        var (wide, high) = size ?? (0, 0); // the scene's own is not known before it is read
        var reading = Read(path, threads, text => WarmUp.Begin(text, (long)wide * high));
        cancellation.ThrowIfCancellationRequested();
        if (reading.Scene is null || !quiet) StandardFile.WriteError(reading.Report());
        if (reading.Scene is not { } scene || size is not var (width, height)) return reading.Scene;
        return scene with { Camera = scene.Camera.WithSize(width, height) };
    }

    /// <summary>Says so where this build draws the scene otherwise than its stored reference shows it: then its judgement is worth
    /// nothing.</summary>
    public static void WarnOfEditedJudge(string path, Scene scene)
    {
        if (path != Standard && StoredReference.Contradiction(path, scene) is { } message) StandardFile.WriteError(message + Environment.NewLine);
    }

    /// <summary>Reads a scene and all that is to be said of it.</summary>
    /// <param name="path">The file, or "-".</param>
    /// <param name="threads">How many threads read a large mesh file; null for one per core.</param>
    /// <param name="look">Sees the text before it is read.</param>
    public static SceneReading Read(string path, int? threads, Action<ReadOnlySpan<byte>>? look = null)
    {
        var reading = path == Standard ? ReadStandardInput(threads, look) : SceneReader.Read(path, threads, look);
        InputFiles.Note([path, .. reading.MeshFiles]);
        return reading;
    }

    /// <remarks>By itself, since the console, too, would be loaded where this is compiled.</remarks>
    private static SceneReading ReadStandardInput(int? threads, Action<ReadOnlySpan<byte>>? look)
    {
        if (StandardInput.IsClosed) throw new ProblemException("raycaster: the scene is to be read from standard input, but that is closed");
        using var input = Console.OpenStandardInput();
        return SceneReader.Read(input, "<stdin>", Environment.CurrentDirectory, threads, look);
    }
}
