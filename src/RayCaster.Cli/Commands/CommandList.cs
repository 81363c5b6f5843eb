namespace RayCaster.Cli;

/// <summary>All commands, and which of them a command line names.</summary>
internal sealed class CommandList
{
    private readonly (string Title, Command[] Commands)[] groups;
    private readonly DrawCommand draw = new();

    /// <param name="groups">The commands but draw and help, in groups with a title.</param>
    public CommandList(params (string Title, Command[] Commands)[] groups)
    {
        this.groups = groups;
        All = [draw, .. groups.SelectMany(group => group.Commands), new HelpCommand(this)];
    }

    public Command[] All { get; }

    /// <summary>The command that the first word names; drawing if it names none.</summary>
    /// <param name="words">The words that are the command's.</param>
    public Command Of(string[] arguments, out string[] words)
    {
        var command = Array.Find(All, command => command.Name == arguments[0]);
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
        command is DrawCommand or HelpCommand ? HelpPage.Of(draw, groups) : HelpPage.Of(command);

    /// <summary>The help page of the command with a name.</summary>
    public string HelpOf(string name) => Array.Find(All, command => command.Name == name) is { } command ? HelpOf(command)
        : throw ProblemException.Usage($"there is no command '{name}'{Spelling.DidYouMean(name, All.Select(known => known.Name), quote: '\'')}");
}
