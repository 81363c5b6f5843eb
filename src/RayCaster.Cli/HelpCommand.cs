namespace RayCaster.Cli;

internal sealed class HelpCommand : Command
{
    public override string Help => HelpText.Full;

    public override bool Takes(Option option) => false;

    public override int Run(CommandLine line, CancellationToken cancellation)
    {
        var text = line.Operands is [var name, ..] ? (All.GetValueOrDefault(name) ?? throw Unknown(name))().Help : Help;
        StandardFile.WriteOutput(text);
        return ExitCode.Done;
    }

    private static ProblemException Unknown(string name) =>
        ProblemException.Usage($"there is no command '{name}'" + (Spelling.Nearest(name, All.Keys) is { } near ? $"; did you mean '{near}'?" : ""));
}
