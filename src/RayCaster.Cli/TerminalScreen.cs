namespace RayCaster.Cli;

internal enum ColorDepth
{
    None, // plain characters and no escape codes
    Palette, // xterm's 256 colours
    Full, // 24 bits
}

/// <summary>The terminal in which the app runs, if there is one.</summary>
internal static class TerminalScreen
{
    private const int UsualColumns = 80, UsualLines = 24, MinColumns = 20, MinLines = 4;

    /// <summary>The colours of standard output, if there is a preview.</summary>
    public static ColorDepth Colors(CommandLine line) =>
        !line.Has(Option.Preview) && !line.Has(Option.Color) ? ColorDepth.None
        : Choose(line[Option.Color], !TakesOutput, Environment.GetEnvironmentVariable);

    /// <summary>The first of these that is set decides: --color, NO_COLOR, FORCE_COLOR, the kind of standard output.</summary>
    /// <param name="variable">Reads an environment variable; an empty one counts as not set.</param>
    internal static ColorDepth Choose(string? when, bool isRedirected, Func<string, string?> variable)
    {
        var isWanted = when switch
        {
            "always" => true,
            "never" => false,
            null or "auto" => !Has("NO_COLOR") && (Has("FORCE_COLOR") || (!isRedirected && variable("TERM") != "dumb")),
            _ => throw ProblemException.Usage($"'{when}' is not a value of --color: choose auto, always or never"),
        };
        if (!isWanted) return ColorDepth.None;
        var isFull = variable("COLORTERM") is "truecolor" or "24bit" || Has("WT_SESSION") // Windows' terminal
            || (variable("TERM") is { } term && (term.EndsWith("-direct") || term.EndsWith("-truecolor")));
        return isFull ? ColorDepth.Full : ColorDepth.Palette;

        bool Has(string name) => !string.IsNullOrEmpty(variable(name));
    }

    public static bool TakesOutput => !Console.IsOutputRedirected;

    /// <summary>A preview that fits into the window, with a line for the prompt.</summary>
    public static TerminalPreview Preview(int width, int height)
    {
        var (columns, lines) = TakesOutput ? (Columns(), Known(() => Console.WindowHeight)) : (UsualColumns, UsualLines);
        return new(width, height, columns, (lines < MinLines ? UsualLines : lines) - 1);
    }

    public static void Show(TerminalPreview preview, ColorDepth colors) => // the escape codes in it are safe
        StandardStreams.WriteOutput(output => output.Write(Encoding.UTF8.GetBytes(preview.Text(colors))));

    /// <summary>The number of columns, or the usual one where it is unknown.</summary>
    public static int Columns() => Known(() => Console.WindowWidth) is >= MinColumns and var columns ? columns : UsualColumns;

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
