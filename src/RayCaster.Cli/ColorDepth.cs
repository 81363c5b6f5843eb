namespace RayCaster.Cli;

/// <summary>Which colours a terminal shows.</summary>
internal enum ColorDepth
{
    /// <summary>None: plain characters and no escape codes.</summary>
    None,

    /// <summary>The 256 of xterm.</summary>
    Palette,

    /// <summary>24 bits.</summary>
    Full,
}

/// <summary>Finds out which colours to use.</summary>
internal static class ColorDepths
{
    /// <summary>--color comes before NO_COLOR, that before FORCE_COLOR, that before what standard output is.</summary>
    /// <param name="when">What --color says: auto, always or never; null if it is not given.</param>
    /// <param name="isRedirected">Whether standard output is no terminal.</param>
    /// <param name="variable">Gives the environment's variables; an empty one counts as not set.</param>
    /// <exception cref="ProblemException">--color says something else.</exception>
    public static ColorDepth Choose(string? when, bool isRedirected, Func<string, string?> variable)
    {
        var isWanted = when switch
        {
            "always" => true,
            "never" => false,
            null or "auto" => !Has("NO_COLOR") && (Has("FORCE_COLOR") || (!isRedirected && variable("TERM") != "dumb")),
            _ => throw ProblemException.Usage($"'{when}' is not when to use colours: choose auto, always or never"),
        };
        if (!isWanted) return ColorDepth.None;
        var isFull = variable("COLORTERM") is "truecolor" or "24bit" || Has("WT_SESSION") // Windows' terminal
            || (variable("TERM") is { } term && (term.EndsWith("-direct") || term.EndsWith("-truecolor")));
        return isFull ? ColorDepth.Full : ColorDepth.Palette;

        bool Has(string name) => !string.IsNullOrEmpty(variable(name));
    }
}
