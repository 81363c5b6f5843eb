namespace RayCaster.Cli;

/// <summary>The terminal in which the app runs, if there is one.</summary>
internal static class TerminalScreen
{
    private const int UsualColumns = 80, UsualLines = 24, FewestColumns = 20, FewestLines = 4;

    /// <summary>The colours of standard output, if there is a preview.</summary>
    /// <exception cref="ProblemException">--color is neither auto nor always nor never.</exception>
    public static ColorDepth Colors(CommandLine line) =>
        !line.Has(Option.Preview) && !line.Has(Option.Color) ? ColorDepth.None // not needed, and the console library takes time to load
        : ColorDepths.Choose(line[Option.Color], !TakesOutput, Environment.GetEnvironmentVariable);

    /// <summary>Whether standard output is a terminal.</summary>
    public static bool TakesOutput => !Console.IsOutputRedirected;

    /// <summary>A preview that fits into the window, with a line for the prompt.</summary>
    public static TerminalPreview Preview(int width, int height)
    {
        var (columns, lines) = !TakesOutput ? (0, 0) : (Width(), Known(() => Console.WindowHeight));
        return new(width, height, columns < FewestColumns ? UsualColumns : columns, (lines < FewestLines ? UsualLines : lines) - 1);
    }

    /// <summary>Writes a preview to standard output.</summary>
    /// <exception cref="ProblemException">Standard output cannot be written.</exception>
    public static void Show(TerminalPreview preview, ColorDepth colors)
    {
        if (OperatingSystem.IsWindows() && TakesOutput) Console.OutputEncoding = Encoding.UTF8; // for the blocks
        StandardFile.WriteOutput(output => output.Write(Encoding.UTF8.GetBytes(preview.Text(colors)))); // the escape codes in it are safe
    }

    /// <summary>The number of columns; 0 if unknown.</summary>
    public static int Width() => Known(() => Console.WindowWidth);

    private static int Known(Func<int> size)
    {
        try
        {
            return size();
        }
        catch (IOException)
        {
            return 0;
        }
    }
}
