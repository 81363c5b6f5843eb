namespace RayCaster.Cli;

/// <summary>The colours that a terminal can show.</summary>
internal enum ColorDepth
{
    None, // plain characters and no escape codes
    Palette, // xterm's 256 colours
    Full, // 24 bits
}

/// <summary>Decides which colours to use.</summary>
internal static class ColorDepths
{
    /// <summary>The first of these that is set decides: --color, NO_COLOR, FORCE_COLOR, the kind of standard output.</summary>
    /// <param name="when">The value of --color: auto, always or never; null if it is not given.</param>
    /// <param name="isRedirected">Whether standard output is no terminal.</param>
    /// <param name="variable">Reads an environment variable; an empty one counts as not set.</param>
    /// <exception cref="ProblemException">--color has another value.</exception>
    public static ColorDepth Choose(string? when, bool isRedirected, Func<string, string?> variable)
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
}
