namespace RayCaster.Cli;

/// <summary>Writes what a command makes: to a file, which is complete or unchanged, or to standard output.</summary>
internal static class OutputFile
{
    /// <summary>Its name in messages.</summary>
    public static string NameOf(string output) => output == StandardStreams.Name ? "standard output" : output;

    /// <param name="cancellation">If cancelled, the old file stays.</param>
    public static void Write(string output, CancellationToken cancellation, Action<Stream> write)
    {
        if (output == StandardStreams.Name)
        {
            StandardStreams.WriteOutput(write);
            return;
        }
        InputFiles.ThrowIfInput(output);
        WrittenFiles.Write(output, write, cancellation);
    }
}
