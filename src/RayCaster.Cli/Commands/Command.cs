namespace RayCaster.Cli;

internal abstract class Command
{
    /// <summary>All commands by their names. Without one of these, the app draws a scene.</summary>
    public static readonly IReadOnlyDictionary<string, Command> All = new Dictionary<string, Command>
    {
        ["draw"] = new DrawCommand(),
        ["check"] = new CheckCommand(),
        ["compare"] = new CompareCommand(),
        ["diagnose"] = new DiagnoseCommand(),
        ["explain"] = new ExplainCommand(),
        ["stitch"] = new StitchCommand(),
        ["orbit"] = new OrbitCommand(),
        ["animate"] = new AnimateCommand(),
        ["sheet"] = new SheetCommand(),
        ["handout"] = new HandOutCommand(),
        ["mark"] = new MarkCommand(),
        ["vary"] = new VaryCommand(),
        ["live"] = new LiveCommand(),
        ["help"] = new HelpCommand(),
    };

    /// <summary>The command that a command line names, even if it is wrong in other ways; null for drawing and for help.</summary>
    public static string? NameIn(string[] arguments)
    {
        for (var i = 0; i < arguments.Length; i++)
        {
            if (!arguments[i].StartsWith('-')) return arguments[i] is not ("draw" or "help") && All.ContainsKey(arguments[i]) ? arguments[i] : null;
            if (Option.Named(arguments[i])?.TakesValue == true) i++;
        }
        return null;
    }

    /// <summary>The text of its help page: lines of at most 90 characters. The options are those that begin a line.</summary>
    public abstract string Help { get; }

    /// <summary>Whether an option is one of the command's; every command also has <see cref="Option.Help"/>.</summary>
    public virtual bool Takes(Option option) => Help.Contains($"\n  {(option.Short == "" ? "    " : option.Short + ", ")}{option.Name} ");

    /// <summary>Runs the command; returns the exit code.</summary>
    /// <exception cref="ProblemException">The command failed; the message is for the user.</exception>
    public abstract int Run(CommandLine line, CancellationToken cancellation);
}
