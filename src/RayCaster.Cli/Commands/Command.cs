namespace RayCaster.Cli;

/// <param name="summary">What it does, for the list of commands.</param>
internal abstract class Command(string name, string operands, string summary)
{
    /// <summary>The argument of commands that read one scene, for <see cref="Arguments"/>.</summary>
    protected static readonly (string, string) Scene = ("<scene>", "The scene file (JSON); \"-\" reads it from standard input.");

    public string Name => name;

    public string Operands => operands;

    public string Summary => summary;

    public abstract string Description { get; }

    public virtual IReadOnlyList<(string Name, string Text)> Arguments => [Scene];

    /// <summary>Its options but --help.</summary>
    public abstract Option[] Options { get; }

    /// <summary>Command lines to try, without the program's name.</summary>
    public virtual string[] Examples => [];

    public virtual string ExitCodes => "0 done, 2 failed.";

    /// <summary>Runs the command; returns the exit code.</summary>
    /// <exception cref="ProblemException">The command failed; the message is for the user.</exception>
    public abstract int Run(CommandLine line);
}
