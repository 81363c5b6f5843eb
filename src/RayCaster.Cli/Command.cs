namespace RayCaster.Cli;

/// <summary>A command of the console app.</summary>
internal abstract class Command
{
    /// <summary>The names of commands. Without one of them, the app draws a scene.</summary>
    public static readonly string[] Names =
        ["draw", "check", "compare", "diagnose", "explain", "stitch", "orbit", "animate", "sheet", "handout", "mark", "vary", "live", "help"];

    /// <summary>The command with a name; null if there is none.</summary>
    public static Command? Named(string name) => name switch
    {
        "draw" => new DrawCommand(),
        "check" => new CheckCommand(),
        "compare" => new CompareCommand(),
        "diagnose" => new DiagnoseCommand(),
        "explain" => new ExplainCommand(),
        "stitch" => new StitchCommand(),
        "orbit" => new OrbitCommand(),
        "animate" => new AnimateCommand(),
        "sheet" => new SheetCommand(),
        "handout" => new HandOutCommand(),
        "mark" => new MarkCommand(),
        "vary" => new VaryCommand(),
        "live" => new LiveCommand(),
        "help" => new HelpCommand(),
        _ => null,
    };

    /// <summary>Its options; every command also has <see cref="Option.Help"/>.</summary>
    public abstract Option[] Options { get; }

    /// <summary>The text of its help page: lines of at most 90 characters.</summary>
    public abstract string Help { get; }

    /// <summary>Runs the command.</summary>
    /// <returns>The exit code.</returns>
    /// <exception cref="ProblemException">The command failed; the message is for the user.</exception>
    public abstract int Run(CommandLine line, CancellationToken cancellation);
}
