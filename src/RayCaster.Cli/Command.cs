namespace RayCaster.Cli;

/// <summary>Something that the console app can be asked for.</summary>
internal abstract class Command
{
    /// <summary>The words that name a command; without one of them a scene is drawn.</summary>
    public static readonly string[] Names =
        ["check", "compare", "diagnose", "explain", "stitch", "orbit", "animate", "sheet", "handout", "mark", "vary", "live", "help"];

    /// <summary>The command of a name; null if there is none.</summary>
    public static Command? Named(string name) => name switch
    {
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

    /// <summary>The options that it takes; <see cref="Option.Help"/> is one of every command's.</summary>
    public abstract Option[] Options { get; }

    /// <summary>Whether an option is one of them.</summary>
    public bool Takes(Option option) => Array.IndexOf(Options, option) >= 0;

    /// <summary>What "help" shows of it: whole lines of at most 90 characters.</summary>
    public abstract string Help { get; }

    /// <summary>Does it.</summary>
    /// <returns>The exit code.</returns>
    /// <exception cref="ProblemException">It cannot be done; the message is for the user.</exception>
    public abstract int Run(CommandLine line, CancellationToken cancellation);
}
