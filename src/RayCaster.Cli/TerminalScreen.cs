using System.Text;

namespace RayCaster.Cli;

/// <summary>The terminal that the app runs in, as far as there is one.</summary>
internal static class TerminalScreen
{
    private const int UsualColumns = 80, UsualLines = 24, FewestColumns = 20, FewestLines = 4;

    /// <summary>Which colours standard output takes, if there is a preview to write to it.</summary>
    /// <exception cref="ProblemException">--color says neither auto nor always nor never.</exception>
    public static ColorDepth Colors(CommandLine line) =>
        !line.Has(Option.Preview) && !line.Has(Option.Color) ? ColorDepth.None // nobody wants to know, and a look at the console takes time
        : ColorDepths.Choose(line[Option.Color], !TakesOutput, Environment.GetEnvironmentVariable);

    /// <summary>Whether standard output is a terminal.</summary>
    public static bool TakesOutput => !Console.IsOutputRedirected;

    /// <summary>A preview for a picture that fits into the window, with a line left for the prompt.</summary>
    /// <param name="width">Pixels in a line of the picture.</param>
    /// <param name="height">Lines of the picture.</param>
    public static TerminalPreview Preview(int width, int height)
    {
        var (columns, lines) = !TakesOutput ? (0, 0) : (Width(), Height());
        return new(width, height, columns < FewestColumns ? UsualColumns : columns, (lines < FewestLines ? UsualLines : lines) - 1);
    }

    /// <summary>Writes a preview to standard output.</summary>
    /// <exception cref="ProblemException">Nobody takes it.</exception>
    public static void Show(TerminalPreview preview, ColorDepth colors)
    {
        if (OperatingSystem.IsWindows() && TakesOutput) Console.OutputEncoding = Encoding.UTF8; // for the blocks
        StandardFile.WriteOutput(output => output.Write(Encoding.UTF8.GetBytes(preview.Text(colors)))); // its escape codes are our own
    }

    /// <summary>How many columns; 0 where that is not known.</summary>
    public static int Width() => Known(() => Console.WindowWidth);

    private static int Height() => Known(() => Console.WindowHeight);

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
