namespace RayCaster.Cli;

/// <summary>All commands, as the help page lists them, and which of them a command line names; without a name it draws a scene.</summary>
internal sealed class CommandList
{
    private readonly DrawCommand draw = new();

    /// <summary>The commands but draw and help, in groups with a title. They are made only where one of them is meant.</summary>
    public (string Title, Command[] Commands)[] Groups => field ??=
    [
        ("For students", [new LiveCommand(), new DiagnoseCommand(), new CompareCommand(), new ExplainCommand(),
            new ModelsCommand(), new MapCommand()]),
        ("For teachers", [new HandOutCommand(), new MarkCommand(), new VaryCommand(), new CheckCommand(), new WrongCommand()]),
        ("For large pictures and many", [new PartCommand(), new StitchCommand(), new OrbitCommand()]),
    ];

    public Command[] All => field ??= [draw, .. Groups.SelectMany(group => group.Commands), new HelpCommand(this)];

    /// <summary>The command that the first word names; drawing if it names none.</summary>
    /// <param name="words">The words that are the command's.</param>
    public Command Find(string[] arguments, out string[] words)
    {
        var mayBeName = arguments[0].All(char.IsAsciiLetter); // the path of a scene has a dot
        var command = mayBeName ? Array.Find(All, command => command.Name == arguments[0]) : null;
        words = command is null ? arguments : arguments[1..];
        return command ?? draw;
    }

    /// <exception cref="ProblemException">The first word is no scene, but looks like the name of a command.</exception>
    public void ThrowIfMisspelled(string[] words)
    {
        if (words is not [var word, ..] || word.StartsWith('-') || File.Exists(word)) return;
        if (Spelling.Nearest(word, All.Select(command => command.Name)) is { } name)
            throw ProblemException.Usage($"there is no command '{word}'; did you mean '{name}'?");
        if (words is [_, var second, ..] && !second.StartsWith('-') && word.All(char.IsAsciiLetter) && !File.Exists(string.Join(' ', words)))
            throw ProblemException.Usage($"there is no command '{word}'; a scene is drawn without one");
    }

    /// <summary>The help page of a command; that of drawing also lists the others.</summary>
    public string HelpOf(Command command) =>
        command is DrawCommand or HelpCommand ? HelpPage.Format(draw, Groups) : HelpPage.Format(command);

    public string HelpOf(string name) => Array.Find(All, command => command.Name == name) is { } command ? HelpOf(command)
        : throw ProblemException.Usage($"there is no command '{name}'{Spelling.DidYouMean(name, All.Select(known => known.Name), quote: '\'')}");
}
