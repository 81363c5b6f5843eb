namespace RayCaster.Cli;

internal sealed class HelpCommand(CommandList commands) : Command("help", "[command]", "Shows this help, or a command's.")
{
    public override string Description => Summary;

    public override IReadOnlyList<(string, string)> Arguments => [];

    public override Option[] Options => [];

    public override int Run(CommandLine line)
    {
        StandardStreams.WriteOutput(commands.HelpOf(line.Operands is [var name, ..] ? name : "help"));
        return ExitCode.Done;
    }
}
